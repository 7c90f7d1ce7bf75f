//! Rapier's `PhysicsWorld`, with ours in the place of its broad phase.

use super::UnisizeBroadPhase;
use super::random::Random;
use super::rapier::prelude::*;

/// A world with our broad phase, and one with Rapier's own.
fn worlds() -> [PhysicsWorld; 2] {
    let ours = PhysicsWorld {
        broad_phase: DefaultBroadPhase::custom(UnisizeBroadPhase::new()),
        ..PhysicsWorld::default()
    };
    [ours, PhysicsWorld::default()]
}

/// Our broad phase in a world.
pub(super) fn unisize(world: &PhysicsWorld) -> &UnisizeBroadPhase {
    let custom = world.broad_phase.custom_ref();
    custom.expect("the world was made with it")
}

/// It asks its broad phase, by its own filtered queries.
#[test]
fn its_queries() {
    let mut random = Random::new(2);
    let mut worlds = worlds();
    for i in 0..150 {
        let body = match i % 5 {
            0 => RigidBodyBuilder::fixed(),
            _ => RigidBodyBuilder::dynamic().linvel(random.within(2.0)),
        };
        let body = body.translation(random.within(8.0));
        // They pass through each other, so no order matters.
        let ball = ColliderBuilder::ball(0.4).sensor(true);
        for world in &mut worlds {
            world.insert(body.clone(), ball.clone());
        }
    }
    let mut hits = 0;
    for _ in 0..600 {
        if random.below(30) == 0 {
            worlds.iter_mut().for_each(PhysicsWorld::step);
        }
        let (from, to) = (random.within(9.0), random.within(1.0));
        let [ours, theirs] = worlds.each_ref().map(|world| {
            let (ray, filter) = (Ray::new(from, to), QueryFilter::only_dynamic());
            let crossed = world.intersect_ray(ray, 20.0, true, filter);
            let around = world.intersect_point(from, QueryFilter::exclude_fixed());
            let found = crossed.map(|(handle, ..)| handle);
            let found = found.chain(around.map(|(handle, ..)| handle));
            let mut found: Vec<_> = found.map(|handle| handle.into_raw_parts()).collect();
            found.sort_unstable();
            found
        });
        assert_eq!(ours, theirs);
        hits += ours.len();
    }
    assert!(hits > 30, "only {hits} hits");
}

/// `set_aabb` by hand, before the first update, as Rapier's docs do: queries find it at once.
#[test]
fn a_box_set_before_the_first_update() {
    let params = IntegrationParameters::default();
    for world in &mut worlds() {
        let ball = world.insert_collider(ColliderBuilder::ball(0.5), None);
        let aabb = world.colliders[ball].compute_aabb();
        world.broad_phase.set_aabb(&params, ball, aabb);
        let ask = |world: &PhysicsWorld, expected: [bool; 2]| {
            let scene = world.query_pipeline();
            let found = [0.0, 5.0].map(|x| {
                let at = Vector::X * x;
                scene.intersect_point(at).next().is_some()
            });
            assert_eq!(found, expected);
        };
        ask(world, [true, false]);
        world.colliders[ball].set_translation(Vector::X * 5.0);
        let aabb = world.colliders[ball].compute_aabb();
        world.broad_phase.set_aabb(&params, ball, aabb);
        ask(world, [false, true]);
        world.step();
        ask(world, [false, true]);
    }
}
