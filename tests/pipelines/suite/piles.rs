//! Piles: bodies that touch many others. The order of contacts matters to the solver, so each world goes its own way, and what
//! its narrow phase knows is held to the boxes of all colliders.

use std::collections::BTreeSet;

use super::random::Random;
use super::rapier::parry::query::contact;
use super::rapier::prelude::*;
use super::snapshot::{Pair, pair};
use super::twins::{Twins, at, cube, cuboid, dynamic, triple};
use super::{Settings, Steppable, UnisizeBroadPhase, World, install, version};

/// Pairs of colliders that penetrate each other by more than rounding errors, found without a broad phase.
fn penetrating(world: &World) -> BTreeSet<Pair> {
    let all: Vec<_> = world.colliders.iter_enabled().collect();
    let mut pairs = BTreeSet::new();
    for (i, (a, first)) in all.iter().enumerate() {
        for (b, second) in &all[i + 1..] {
            let is_dynamic = [first, second].iter().any(|collider| {
                let body = collider.parent().map(|body| &world.bodies[body]);
                body.is_some_and(|body| body.is_dynamic())
            });
            let [one, other] = [first, second].map(|collider| collider.compute_aabb());
            if is_dynamic && one.intersects(&other) {
                let (one, other) = (first.position(), second.position());
                let met = contact(one, first.shape(), other, second.shape(), 0.0);
                if met.is_ok_and(|met| met.is_some_and(|met| met.dist < -1.0e-3)) {
                    pairs.insert(pair(*a, *b));
                }
            }
        }
    }
    pairs
}

/// Drops bodies into a box; all must come to rest inside, at a sound depth.
fn settle<B: Steppable>(
    mut broad_phase: B,
    validate: impl Fn(&B),
    collider: impl Fn(usize) -> ColliderBuilder,
) {
    let mut world = World::new(at(0.0, -9.81));
    let floor = cuboid([50.0, 1.0, 50.0]).translation(at(0.0, -1.0));
    world.colliders.insert(floor);
    for side in [-1.0, 1.0] {
        let wall = cuboid([0.5, 20.0, 20.0]).translation(at(4.0 * side, 15.0));
        world.colliders.insert(wall);
    }
    let mut bodies = Vec::new();
    for row in 0..8 {
        for column in 0..5 {
            let (x, y) = (1.2 * column as Real - 2.4, 1.1 * row as Real + 0.6);
            let body = dynamic(x + 0.03 * row as Real, y);
            bodies.push(world.insert(body, collider(5 * row + column)));
        }
    }
    for step in 0..2000 {
        // What the next step finds is where bodies are now.
        let expected = if step % 7 == 0 {
            penetrating(&world)
        } else {
            BTreeSet::new()
        };
        world.step(broad_phase.for_step(), &(), &());
        validate(&broad_phase);
        let is_found = |&&[a, b]: &&Pair| {
            let [a, b] =
                [a, b].map(|(index, generation)| ColliderHandle::from_raw_parts(index, generation));
            world
                .narrow_phase
                .contact_pair(a, b)
                .is_some_and(version::is_found)
        };
        let missed: Vec<_> = expected.iter().filter(|pair| !is_found(pair)).collect();
        assert!(missed.is_empty(), "step {step} misses {missed:?}");
        if bodies.iter().all(|&body| world.bodies[body].is_sleeping()) {
            for &body in &bodies {
                let place = world.bodies[body].translation();
                assert!(place.y > 0.2 && place.y < 12.0 && place.x.abs() < 50.0);
            }
            return;
        }
    }
    panic!("the pile does not come to rest");
}

#[test]
fn cubes_come_to_rest() {
    settle(
        install(UnisizeBroadPhase::new()),
        |ours| ours.validate(),
        |_| cube(),
    );
    settle(DefaultBroadPhase::new(), |_| (), |_| cube());
}

#[test]
fn all_sorts_come_to_rest_without_foresight() {
    let settings = Settings::default().with_foresight(0);
    let broad_phase = UnisizeBroadPhase::with_settings(settings);
    settle(
        install(broad_phase),
        |ours| ours.validate(),
        |i| match i % 3 {
            0 => cuboid([0.5, 0.3, 0.4]),
            1 => cuboid([0.4; 3]),
            _ => cuboid([0.25, 0.4, 0.5]),
        },
    );
}

/// Many bodies far apart, each on its own pile of two, so that nothing but the pairs decides what happens.
#[test]
fn many_small_piles() {
    let mut twins = Twins::heavy();
    for i in 0..60 {
        let place = triple([4.0 * (i % 10) as Real, 4.0 * (i / 10) as Real, 0.0]);
        twins.insert(
            RigidBodyBuilder::fixed().translation(place),
            cuboid([0.8, 0.2, 0.8]),
        );
        let above = place + at(0.0, 0.9 + 0.01 * i as Real);
        twins.insert(
            RigidBodyBuilder::dynamic().translation(above),
            ColliderBuilder::ball(0.3),
        );
    }
    let seen = twins.steps(200);
    assert_eq!(seen.contacts.len(), 60);
    assert!(seen.asleep.len() > 60 / 2, "{} sleep", seen.asleep.len());
}

/// So many that ours uses its threads, if it has any: what flies about is seen by sensors alone, so no order matters.
#[test]
fn a_swarm() {
    let mut random = Random::new(3);
    let mut twins = Twins::weightless();
    let side = if DIM == 2 { 160.0 } else { 60.0 };
    for i in 0..20_000 {
        let body = RigidBodyBuilder::kinematic_velocity_based()
            .translation(random.within(side / 2.0))
            .linvel(random.within(10.0));
        let types = ActiveCollisionTypes::all();
        let ball = ColliderBuilder::ball(0.5).active_collision_types(types);
        let ball = ball.sensor(i % 100 != 0);
        twins.both(|world| world.insert(body.clone(), ball.clone()));
    }
    let mut seen = 0;
    for _ in 0..4 {
        seen += twins.step().intersections.len();
    }
    assert!(seen > 1_000, "{seen}");
}
