//! Scene queries: the same answers as from Rapier's own tree.

use std::cell::Cell;
use std::collections::BTreeSet;
use std::fmt::Debug;

use super::rapier::parry::partitioning::BvhNode;
use super::rapier::parry::query::{
    DefaultQueryDispatcher, NonlinearRigidMotion, QueryDispatcher, ShapeCastOptions,
};
use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, dynamic, fixed, triple};
use super::{World, spin};

/// Balls and cubes in a wide grid, some of them moving.
fn scattered() -> Twins {
    let mut twins = Twins::weightless();
    for i in 0..8 {
        for j in 0..8 {
            let (x, y) = (3.0 * i as Real, 3.0 * j as Real);
            let body = match (i + j) % 3 {
                0 => fixed(x, y),
                1 => dynamic(x, y),
                _ => dynamic(x, y).linvel(at(0.3, 0.2)),
            };
            let collider = match i % 2 {
                0 => cube(),
                _ => ColliderBuilder::ball(0.6),
            };
            twins.insert(body, collider);
        }
    }
    twins
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
            twins.both(|world| world.remove(body));
        }
        twins.step();
        let mut hits = 0;
        for i in 0..5 {
            let ray = Ray::new(at(3.0 * i as Real, -5.0).into(), at(0.0, 1.0));
            let hit = same(&twins, |scene| scene.cast_ray(&ray, 100.0, true));
            hits += usize::from(hit.is_some());
        }
        assert_eq!(hits, left);
    }
}

/// Asks both worlds the same, and compares the answers.
fn same<T: PartialEq + Debug>(twins: &Twins, ask: impl Fn(QueryPipeline<'_>) -> T) -> T {
    let [ours, theirs] = both(twins, ask);
    assert_eq!(ours, theirs);
    ours
}

/// Asks both worlds the same.
fn both<T>(twins: &Twins, ask: impl Fn(QueryPipeline<'_>) -> T) -> [T; 2] {
    let dispatcher = &DefaultQueryDispatcher;
    let filter = QueryFilter::default();
    let (ours, theirs) = (&twins.ours, &twins.theirs);
    let unisize = &twins.unisize;
    let ours = unisize.as_query_pipeline(dispatcher, &ours.bodies, &ours.colliders, filter);
    let default = &twins.default;
    let theirs = default.as_query_pipeline(dispatcher, &theirs.bodies, &theirs.colliders, filter);
    [ask(ours), ask(theirs)]
}

fn indices<T>(hits: impl Iterator<Item = (ColliderHandle, T)>) -> BTreeSet<u32> {
    hits.map(|(handle, _)| handle.into_raw_parts().0).collect()
}

/// Parry runs a nonlinear cast against a ball around each node of the tree as well, and for some motions misses what is
/// behind one: Rapier's broad phase does, and so does ours, by the shapes of their trees. So where the answers differ, one
/// of them must be what is hit first of all colliders, each by itself, and the other one a later hit, or none.
fn compare_nonlinear_casts(twins: &Twins, start: Isometry<Real>, probe: &Ball) -> Option<Real> {
    let motion = NonlinearRigidMotion::new(start, Point::origin(), at(-1.0, -0.3), spin(0.5));
    let [ours, theirs] = both(twins, |scene| {
        let hit = scene.cast_shape_nonlinear(&motion, probe, 0.0, 10.0, false);
        hit.map(|(_, hit)| hit.time_of_impact)
    });
    if ours != theirs {
        let colliders = twins.ours.colliders.iter_enabled();
        let times: Vec<_> = colliders
            .filter_map(|(_, collider)| {
                let still = NonlinearRigidMotion::constant_position(*collider.position());
                let (dispatcher, shape) = (DefaultQueryDispatcher, collider.shape());
                let hit = dispatcher
                    .cast_shapes_nonlinear(&still, shape, &motion, probe, 0.0, 10.0, false)
                    .expect("these shapes can be cast");
                hit.map(|hit| hit.time_of_impact)
            })
            .collect();
        let first = times.iter().copied().min_by(Real::total_cmp);
        assert!(ours == first || theirs == first, "{ours:?}, {theirs:?}");
        for time in ours.iter().chain(&theirs) {
            assert!(times.contains(time), "{time} is no hit");
        }
    }
    ours
}

fn compare_queries(twins: &Twins) -> usize {
    let mut hits = 0;
    for i in 0..60 {
        let (x, y) = (-2.0 + 0.45 * i as Real, 25.0 - 0.37 * i as Real);
        let ray = Ray::new(at(x, -5.0).into(), at(0.05 * y - 0.6, 1.0));
        hits += same(twins, |scene| scene.cast_ray(&ray, 100.0, true)).map_or(0, |_| 1);
        hits += same(twins, |scene| {
            let crossed = scene.intersect_ray(ray, 100.0, true);
            indices(crossed.map(|(handle, collider, _)| (handle, collider)))
        })
        .len();
        let point = at(x, 0.9 * y).into();
        hits += same(twins, |scene| indices(scene.intersect_point(point))).len();
        let nearest = same(twins, |scene| {
            let nearest = scene.project_point(&point, Real::MAX, true);
            nearest.map(|(_, projection)| projection.point)
        });
        assert!(nearest.is_some());
        let pose = at(x, y).into();
        let probe = Ball::new(1.7);
        hits += same(twins, |scene| indices(scene.intersect_shape(pose, &probe))).len();
        let region = Aabb::from_half_extents(point, triple([1.5; 3]));
        hits += same(twins, |scene| {
            indices(scene.intersect_aabb_conservative(region))
        })
        .len();
        let cast = same(twins, |scene| {
            let options = ShapeCastOptions::with_max_time_of_impact(50.0);
            let hit = scene.cast_shape(&pose, &at(-1.0, -0.3), &probe, options);
            hit.map(|(_, hit)| hit.time_of_impact)
        });
        hits += cast.map_or(0, |_| 1);
        hits += compare_nonlinear_casts(twins, pose, &probe).map_or(0, |_| 1);
    }
    hits
}

#[test]
fn as_in_rapier() {
    let mut twins = scattered();
    twins.step();
    assert!(compare_queries(&twins) > 100);
    twins.steps(30);
    assert!(compare_queries(&twins) > 100);
}

#[test]
fn after_changes() {
    let mut twins = scattered();
    twins.steps(3);
    let handles: Vec<_> = twins
        .ours
        .colliders
        .iter()
        .map(|(handle, _)| handle)
        .collect();
    for (i, &handle) in handles.iter().enumerate() {
        match i % 5 {
            0 => twins.change(handle, |collider| collider.set_enabled(false)),
            1 => twins.change(handle, |collider| {
                collider.set_shape(SharedShape::ball(1.0))
            }),
            2 => twins.both(|world| {
                let body = world.colliders[handle].parent();
                world.remove(body.expect("every collider has a body"));
            }),
            _ => {}
        }
    }
    twins.step();
    assert!(compare_queries(&twins) > 20);
}

#[test]
fn with_the_sets_borrowed_mutably() {
    let mut twins = scattered();
    twins.step();
    let World {
        bodies, colliders, ..
    } = &mut twins.ours;
    let filter = QueryFilter::only_dynamic();
    let dispatcher = &DefaultQueryDispatcher;
    let scene = twins
        .unisize
        .as_query_pipeline_mut(dispatcher, bodies, colliders, filter);
    let ray = Ray::new(at(-5.0, 0.0).into(), at(1.0, 0.0));
    let (hit, _) = scene.as_ref().cast_ray(&ray, 100.0, true).expect("it hits");
    let parent = scene.colliders[hit]
        .parent()
        .expect("every collider has a body");
    assert!(scene.bodies[parent].is_dynamic());
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
    let mut twins = scattered();
    twins.step();
    let dispatcher = &DefaultQueryDispatcher;
    let filter = QueryFilter::default();
    let (unisize, mut world) = (&twins.unisize, World::new(Vector::zeros()));
    world.bodies = twins.ours.bodies.clone();
    world.colliders = twins.ours.colliders.clone();
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
    let twins = Twins::weightless();
    let ray = Ray::new(Point::origin(), at(1.0, 0.0));
    assert!(same(&twins, |scene| scene.cast_ray(&ray, 100.0, true)).is_none());
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
            twins.both(|world| world.remove(bodies[i]));
            bodies[i] = twins.insert(body(step % 120), cube()).0;
        }
        twins.step();
        // At times nobody asks, for long enough for the tree to be given up.
        if step % 500 > 400 {
            continue;
        }
        let (x, y) = ((step % 37) as Real - 18.0, (step % 23) as Real - 11.0);
        let ray = Ray::new(at(x, -30.0).into(), at(0.1, 1.0));
        hits += same(&twins, |scene| scene.cast_ray(&ray, 100.0, true)).map_or(0, |_| 1);
        let pose = at(y, x).into();
        let found = same(&twins, |scene| {
            indices(scene.intersect_shape(pose, &Ball::new(2.0)))
        });
        hits += found.len();
    }
    assert!(hits > 3000, "only {hits} hits");
}
