//! Scene queries in random worlds: the same answers as from Rapier's own tree, in `PhysicsWorld` and beside it.

use std::collections::BTreeSet;
use std::fmt::Debug;

use oorandom::Rand32;

use super::UnisizeBroadPhase;
use super::rapier::parry::query::ShapeCastOptions;
use super::rapier::prelude::*;
use super::twins::{Twins, cuboid, triple};

/// A vector with each coordinate within this distance of 0.
fn within(random: &mut Rand32, distance: Real) -> Vector {
    triple(std::array::from_fn(|_| {
        distance * (2.0 * random.rand_float() - 1.0) as Real
    }))
}

/// Bodies at random places, most of which fly about and meet nothing.
fn scattered(random: &mut Rand32) -> Twins {
    let mut twins = Twins::weightless();
    for i in 0..150 {
        let body = match i % 5 {
            0 => RigidBodyBuilder::fixed(),
            1 => RigidBodyBuilder::kinematic_velocity_based().linvel(within(random, 2.0)),
            _ => RigidBodyBuilder::dynamic().linvel(within(random, 2.0)),
        };
        let collider = match i % 4 {
            0 => ColliderBuilder::ball(0.4),
            1 => cuboid([0.5, 0.2, 0.3]),
            2 => ColliderBuilder::capsule_y(0.3, 0.2),
            _ => ColliderBuilder::ball(0.2).sensor(true),
        };
        // Each in a group of its own, so that they pass through each other and no order matters.
        let groups = InteractionGroups::new(Group::GROUP_1, Group::NONE, InteractionTestMode::And);
        let collider = collider.collision_groups(groups);
        twins.insert(body.translation(within(random, 8.0)), collider);
    }
    twins
}

/// Asks both worlds the same, and compares the answers.
#[track_caller]
fn same<T: PartialEq + Debug>(twins: &Twins, ask: impl Fn(&PhysicsWorld) -> T) -> T {
    let [ours, theirs] = [&twins.ours, &twins.theirs].map(ask);
    assert_eq!(format!("{ours:#?}"), format!("{theirs:#?}"));
    ours
}

fn indices<T>(hits: impl Iterator<Item = (ColliderHandle, T)>) -> BTreeSet<u32> {
    hits.map(|(handle, _)| handle.into_raw_parts().0).collect()
}

/// The boxes of the leaves, by index.
fn leaves(world: &PhysicsWorld) -> Vec<(u32, Option<Aabb>)> {
    let scene = world.query_pipeline();
    let colliders = world.colliders.iter().map(|(handle, _)| {
        let index = handle.into_raw_parts().0;
        (index, scene.bvh.leaf_node(index).map(|leaf| leaf.aabb()))
    });
    colliders.collect()
}

/// What may be in a region goes by the boxes of the leaves. In Rapier's own tree those that a step has set are larger than their
/// ancestors until the next step, by the margin, so it may miss one of which only the margin is there.
fn compare_regions(twins: &Twins, region: Aabb) -> usize {
    let [ours, theirs] = [&twins.ours, &twins.theirs].map(|world| {
        let scene = world.query_pipeline();
        indices(scene.intersect_aabb_conservative(region))
    });
    let leaves = leaves(&twins.ours).into_iter();
    let expected: BTreeSet<_> = leaves
        .filter(|(_, leaf)| leaf.is_some_and(|leaf| leaf.intersects(&region)))
        .map(|(index, _)| index)
        .collect();
    assert_eq!(ours, expected);
    assert!(ours.is_superset(&theirs), "{ours:?} and {theirs:?}");
    ours.len()
}

fn compare(twins: &Twins, random: &mut Rand32) -> usize {
    let mut hits = 0;
    same(twins, leaves);
    for _ in 0..30 {
        let (from, to) = (within(random, 9.0), within(random, 1.0));
        let ray = Ray::new(from, to);
        // If a ray begins inside several, any may be returned.
        let hit = same(twins, |world| {
            let hit = world.query_pipeline().cast_ray(&ray, 20.0, true);
            hit.map(|(handle, time)| (time, (time > 0.0).then_some(handle)))
        });
        hits += usize::from(hit.is_some());
        hits += same(twins, |world| {
            let scene = world.query_pipeline();
            let crossed = scene.intersect_ray(ray, 20.0, true);
            indices(crossed.map(|(handle, collider, _)| (handle, collider)))
        })
        .len();
        hits += same(twins, |world| {
            indices(world.query_pipeline().intersect_point(from))
        })
        .len();
        let nearest = same(twins, |world| {
            let scene = world.query_pipeline();
            let nearest = scene.project_point(from, Real::MAX, false);
            nearest.map(|(_, projection)| projection.point)
        });
        assert!(nearest.is_some());
        let (pose, probe) = (Pose::from_translation(from), Ball::new(1.0));
        hits += same(twins, |world| {
            let scene = world.query_pipeline();
            indices(scene.intersect_shape(pose, &probe))
        })
        .len();
        let region = Aabb::new(from, from + triple([1.5; 3]));
        hits += compare_regions(twins, region);
        let cast = same(twins, |world| {
            let options = ShapeCastOptions::with_max_time_of_impact(50.0);
            let scene = world.query_pipeline();
            let hit = scene.cast_shape(&pose, to, &probe, options);
            hit.map(|(_, hit)| hit.time_of_impact)
        });
        hits += usize::from(cast.is_some());
        // The world's own, which go to the tree as well.
        same(twins, |world| {
            let filter = QueryFilter::only_dynamic();
            let crossed = world.intersect_ray(ray, 20.0, true, filter);
            indices(crossed.map(|(handle, collider, _)| (handle, collider)))
        });
        same(twins, |world| {
            let filter = QueryFilter::exclude_fixed();
            indices(world.intersect_point(from, filter))
        });
    }
    hits
}

#[test]
fn in_random_worlds() {
    for seed in 0..4 {
        let mut random = Rand32::new(seed);
        let mut twins = scattered(&mut random);
        let mut hits = 0;
        for round in 0..20 {
            twins.steps(1 + round % 4);
            hits += compare(&twins, &mut random);
        }
        assert!(hits > 500, "only {hits} hits");
    }
}

#[test]
fn after_colliders_have_changed() {
    let mut random = Rand32::new(9);
    let mut twins = scattered(&mut random);
    twins.step();
    for round in 0..30 {
        let colliders = twins.ours.colliders.iter();
        let handles: Vec<_> = colliders.map(|(handle, _)| handle).collect();
        let pick = handles[random.rand_range(0..handles.len() as u32) as usize];
        match round % 4 {
            0 => twins.change(pick, |collider| collider.set_enabled(false)),
            1 => twins.change(pick, |collider| collider.set_shape(SharedShape::ball(1.0))),
            2 => {
                let body = twins.ours.colliders[pick].parent();
                twins.both(|world| world.remove_body(body.expect("it has one")).is_some());
            }
            _ => {
                let place = within(&mut random, 8.0);
                let body = RigidBodyBuilder::dynamic().translation(place);
                twins.insert(body, ColliderBuilder::ball(0.4));
            }
        }
        twins.step();
        compare(&twins, &mut random);
    }
}

/// `set_aabb` by hand, before the first update, as Rapier's docs do: queries find it at once.
#[test]
fn a_box_set_before_the_first_update() {
    let params = IntegrationParameters::default();
    let mut worlds = [
        DefaultBroadPhase::custom(UnisizeBroadPhase::new()),
        DefaultBroadPhase::new(),
    ]
    .map(|broad_phase| PhysicsWorld {
        broad_phase,
        ..PhysicsWorld::default()
    });
    for world in &mut worlds {
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
