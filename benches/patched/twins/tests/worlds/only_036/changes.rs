//! What a user changes and what numbers there are, where Rapier 0.27 does otherwise.

use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, dynamic, fixed};
use super::{PairFilter, World};

/// Rapier's own broad phase looks at the skin again when the collider moves, and not when it is listed for anything else.
#[test]
fn a_skin_counts_from_the_next_move_on() {
    for filter in [PairFilter::Groups, PairFilter::Shapes] {
        let mut twins = Twins::with_filter(filter).without_gravity();
        let (wall, left) = twins.insert(fixed(0.0, 0.0), cube());
        let (_, right) = twins.insert(dynamic(1.2, 0.0), cube());
        twins.steps(3);
        twins.change(left, |left| left.set_contact_skin(0.3));
        assert!(!twins.steps(3).touches(left, right));
        twins.change(left, |left| left.set_friction(0.3));
        assert!(!twins.steps(3).touches(left, right));
        twins.change_body(wall, |wall| wall.set_translation(at(0.001, 0.0), true));
        assert!(twins.step().touches(left, right));
    }
}

/// What was changed and changed back within a step is inserted afresh, without a margin, so its pairs end earlier.
#[test]
fn there_and_back() {
    let changes: [fn(&mut World, RigidBodyHandle, ColliderHandle); 6] = [
        |world, _, collider| {
            let collider = &mut world.colliders[collider];
            let groups = collider.solver_groups();
            collider.set_solver_groups(InteractionGroups::none());
            collider.set_solver_groups(groups);
        },
        |world, _, collider| {
            let collider = &mut world.colliders[collider];
            let groups = collider.collision_groups();
            collider.set_collision_groups(InteractionGroups::none());
            collider.set_collision_groups(groups);
        },
        |world, body, _| {
            world.bodies[body].set_dominance_group(1);
            world.bodies[body].set_dominance_group(0);
        },
        |world, body, _| {
            world.bodies[body].set_body_type(RigidBodyType::Fixed, true);
            world.bodies[body].set_body_type(RigidBodyType::Dynamic, true);
            world.bodies[body].set_linvel(at(0.4, 0.0), true);
        },
        |world, body, collider| {
            let World {
                colliders, bodies, ..
            } = world;
            colliders.set_parent(collider, None, bodies);
            colliders.set_parent(collider, Some(body), bodies);
        },
        |world, _, collider| {
            world.colliders[collider].set_enabled(false);
            world.colliders[collider].set_enabled(true);
        },
    ];
    let mut ends = Vec::new();
    for change in changes {
        for each in 1..4 {
            let mut twins = Twins::with_filter(PairFilter::Groups).without_gravity();
            let (_, wall) = twins.insert(fixed(0.0, 0.0), cube());
            let (body, ball) = twins.insert(dynamic(1.0, 0.0), ColliderBuilder::ball(0.5));
            twins.change_body(body, |body| body.set_linvel(at(0.4, 0.0), true));
            let mut end = None;
            for step in 0..60 {
                if step % each == 0 {
                    twins.both(|world| change(world, body, ball));
                }
                twins.step();
                let held =
                    |world: &mut World| world.narrow_phase.contact_pair(wall, ball).is_some();
                if !twins.both(held) {
                    end = end.or(Some(step));
                }
            }
            ends.push(end.expect("it ends"));
        }
    }
    assert!(ends.iter().min() < ends.iter().max(), "{ends:?}");
}

/// The own broad phase of Rapier 0.27 panics.
#[test]
fn velocities_that_are_not_finite() {
    for speed in [Real::NAN, Real::INFINITY, Real::MAX, 1.0e30] {
        let mut twins = Twins::weightless();
        twins.insert(dynamic(5.0, 0.5), cube());
        twins.insert(fixed(5.9, 0.5), cube());
        let (body, _) = twins.insert(dynamic(0.0, 0.5), cube());
        twins.steps(3);
        twins.change_body(body, |body| body.set_linvel(at(speed, 0.0), true));
        twins.steps(5);
    }
}
