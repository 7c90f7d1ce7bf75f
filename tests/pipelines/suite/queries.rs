//! Scene queries: the same answers as from Rapier's own tree.

use std::cell::Cell;
use std::collections::BTreeSet;
use std::fmt::Debug;

use oorandom::Rand32;

use super::World;
use super::rapier::parry::partitioning::BvhNode;
use super::rapier::parry::query::DefaultQueryDispatcher;
use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, cuboid, fixed, triple};
use super::version::{self, Vector, cast_ball, groups, pose, project_point};

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
        let collider = collider.collision_groups(groups(Group::GROUP_1, Group::NONE));
        twins.insert(body.translation(within(random, 8.0)), collider);
    }
    twins
}

/// Asks both worlds the same, and compares the answers.
#[track_caller]
fn same<T: PartialEq + Debug>(twins: &mut Twins, ask: impl Fn(QueryPipeline<'_>) -> T) -> T {
    let [ours, theirs] = twins.answers(|_, scene| ask(scene));
    assert_eq!(ours, theirs);
    ours
}

fn indices<T>(hits: impl Iterator<Item = (ColliderHandle, T)>) -> BTreeSet<u32> {
    hits.map(|(handle, _)| handle.into_raw_parts().0).collect()
}

/// The boxes of the leaves, by index.
fn leaves(world: &World, scene: &QueryPipeline<'_>) -> Vec<(u32, Option<Aabb>)> {
    let colliders = world.colliders.iter().map(|(handle, _)| {
        let index = handle.into_raw_parts().0;
        (index, scene.bvh.leaf_node(index).map(|leaf| leaf.aabb()))
    });
    colliders.collect()
}

/// What may be in a region goes by the boxes of the leaves. In the own tree of Rapier 0.36, those that a step has set are larger than
/// their ancestors until the next step, by the margin, so it may miss one of which only the margin is there.
fn compare_regions(twins: &mut Twins, region: Aabb) -> usize {
    let [(leaves, ours), (their_leaves, theirs)] = twins.answers(|world, scene| {
        let found = indices(scene.intersect_aabb_conservative(region));
        (leaves(world, &scene), found)
    });
    assert_eq!(leaves, their_leaves);
    let expected: BTreeSet<_> = leaves
        .into_iter()
        .filter(|(_, leaf)| leaf.is_some_and(|leaf| leaf.intersects(&region)))
        .map(|(index, _)| index)
        .collect();
    assert_eq!(ours, expected);
    assert!(ours.is_superset(&theirs), "{ours:?} and {theirs:?}");
    ours.len()
}

fn compare(twins: &mut Twins, random: &mut Rand32) -> usize {
    let mut hits = 0;
    for _ in 0..30 {
        let (from, to) = (within(random, 9.0), within(random, 1.0));
        let ray = Ray::new(from.into(), to);
        // If a ray begins inside several, any may be returned.
        let hit = same(twins, |scene| {
            let hit = scene.cast_ray(&ray, 20.0, true);
            hit.map(|(handle, time)| (time, (time > 0.0).then_some(handle)))
        });
        hits += usize::from(hit.is_some());
        hits += same(twins, |scene| {
            let crossed = scene.intersect_ray(ray, 20.0, true);
            indices(crossed.map(|(handle, collider, _)| (handle, collider)))
        })
        .len();
        hits += same(twins, |scene| indices(scene.intersect_point(from.into()))).len();
        let nearest = same(twins, |scene| {
            project_point(&scene, from).map(|nearest| nearest.point)
        });
        assert!(nearest.is_some());
        let (start, probe) = (pose(from), Ball::new(1.0));
        hits += same(twins, |scene| indices(scene.intersect_shape(start, &probe))).len();
        let region = Aabb::new(from.into(), (from + triple([1.5; 3])).into());
        hits += compare_regions(twins, region);
        let cast = same(twins, |scene| {
            cast_ball(&scene, &start, to, &probe).map(|hit| hit.time_of_impact)
        });
        hits += usize::from(cast.is_some());
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
            hits += compare(&mut twins, &mut random);
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
                twins.remove(body.expect("it has one"));
            }
            _ => {
                let place = within(&mut random, 8.0);
                let body = RigidBodyBuilder::dynamic().translation(place);
                twins.insert(body, ColliderBuilder::ball(0.4));
            }
        }
        twins.step();
        compare(&mut twins, &mut random);
    }
}

/// Parry builds trees of one and of two leaves as special cases.
#[test]
fn a_few_colliders_with_any_index() {
    for left in 1..=4 {
        let mut twins = Twins::weightless();
        let all: Vec<_> = (0..5)
            .map(|i| twins.insert(fixed(3.0 * i as Real, 0.0), cube()))
            .collect();
        twins.step();
        for &(body, _) in &all[..5 - left] {
            twins.remove(body);
        }
        twins.step();
        let mut hits = 0;
        for i in 0..5 {
            let ray = Ray::new(at(3.0 * i as Real, -5.0).into(), at(0.0, 1.0));
            let hit = same(&mut twins, |scene| scene.cast_ray(&ray, 100.0, true));
            hits += usize::from(hit.is_some());
        }
        assert_eq!(hits, left);
    }
}

#[test]
fn with_the_sets_borrowed_mutably() {
    let mut twins = scattered(&mut Rand32::new(5));
    twins.step();
    let filter = QueryFilter::only_dynamic();
    let mut hits = 0;
    for i in 0..60 {
        let ray = Ray::new(at(-9.0, 0.3 * i as Real - 9.0).into(), at(1.0, 0.0));
        let hit = twins.both_scenes(filter, |scene| {
            let (hit, _) = scene.as_ref().cast_ray(&ray, 100.0, true)?;
            let parent = scene.colliders[hit]
                .parent()
                .expect("every collider has a body");
            Some(scene.bodies[parent].is_dynamic())
        });
        assert_ne!(hit, Some(false));
        hits += usize::from(hit.is_some());
    }
    assert!(hits > 5, "only {hits} hits");
}

/// The address of the first node of the tree.
fn first_node(scene: &QueryPipeline<'_>) -> *const BvhNode {
    let first = Cell::new(std::ptr::null::<BvhNode>());
    let mut leaves = scene.bvh.leaves(|node| {
        if first.get().is_null() {
            first.set(node);
        }
        true
    });
    assert!(leaves.next().is_some());
    first.get()
}

/// `tests/memory` checks that it is kept over updates in which no box changes.
#[test]
fn one_tree_for_all_queries_between_two_updates() {
    let mut twins = scattered(&mut Rand32::new(6));
    twins.step();
    let dispatcher = &DefaultQueryDispatcher;
    let filter = QueryFilter::default();
    let mut world = World::new(Vector::default());
    world.bodies = twins.ours.bodies.clone();
    world.colliders = twins.ours.colliders.clone();
    let unisize = version::asked(&mut twins.unisize);
    let (bodies, colliders) = (&twins.ours.bodies, &twins.ours.colliders);
    // The first borrows its tree until the end, so that no other could be in the same memory.
    let first = unisize.as_query_pipeline(dispatcher, bodies, colliders, filter);
    let second = unisize.as_query_pipeline(dispatcher, bodies, colliders, filter);
    assert_eq!(first_node(&first), first_node(&second));
    let (bodies, colliders) = (&mut world.bodies, &mut world.colliders);
    let third = unisize.as_query_pipeline_mut(dispatcher, bodies, colliders, filter);
    assert_eq!(first_node(&first), first_node(&third.as_ref()));
}

#[test]
fn an_empty_world() {
    let mut twins = Twins::weightless();
    let ray = Ray::new(at(0.0, 0.0).into(), at(1.0, 0.0));
    assert!(same(&mut twins, |scene| scene.cast_ray(&ray, 100.0, true)).is_none());
}

/// The tree that is kept has then been brought up to date thousands of times, and given new leaves, and lost some.
#[test]
fn for_thousands_of_steps() {
    let mut twins = Twins::weightless();
    let body = |i: usize| {
        let turn = 0.7 * i as Real;
        let place = at((i % 12) as Real * 2.5 - 15.0, (i / 12) as Real * 2.5 - 12.0);
        RigidBodyBuilder::kinematic_velocity_based()
            .translation(place)
            .linvel(at(turn.cos(), turn.sin()))
    };
    let mut bodies: Vec<_> = (0..120).map(|i| twins.insert(body(i), cube()).0).collect();
    let mut hits = 0;
    for step in 0..3000_usize {
        // They fly to and fro, and some are replaced.
        if step % 97 == 0 {
            for &body in &bodies {
                twins.change_body(body, |body| body.set_linvel(-body.linvel(), true));
            }
        }
        if step % 11 == 0 {
            let i = step * 7 % bodies.len();
            twins.remove(bodies[i]);
            bodies[i] = twins.insert(body(step % 120), cube()).0;
        }
        twins.step();
        // At times nobody asks, for long enough for the tree to be given up.
        if step % 500 > 400 {
            continue;
        }
        let (x, y) = ((step % 37) as Real - 18.0, (step % 23) as Real - 11.0);
        let ray = Ray::new(at(x, -30.0).into(), at(0.1, 1.0));
        hits += same(&mut twins, |scene| scene.cast_ray(&ray, 100.0, true)).map_or(0, |_| 1);
        let start = pose(at(y, x));
        let found = same(&mut twins, |scene| {
            indices(scene.intersect_shape(start, &Ball::new(2.0)))
        });
        hits += found.len();
    }
    assert!(hits > 3000, "only {hits} hits");
}
