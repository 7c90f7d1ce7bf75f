//! Ghosts: overlapping balls of a collision group that does not meet itself, in a closed box.
//!
//! They drift slowly and rebound from the walls alone. Each overlaps a dozen others, pairs of which the narrow phase
//! makes nothing.

use super::rapier::prelude::*;
use super::{Container, Lattice, Random, Stage, UP, floating, jitter, version};

/// The radius of every ball.
const RADIUS: Real = 0.5;

/// The distance between balls at the start, much less than their diameter.
const SPACING: Real = 0.6;

/// The largest speed along each axis, in length units per second.
const SPEED: Real = 0.5;

/// What meets everything but its own kind.
const GHOSTS: InteractionGroups =
    version::groups(Group::GROUP_2, Group::ALL.difference(Group::GROUP_2));

pub(super) fn build(bodies: usize, random: &mut Random) -> Stage {
    let lattice = Lattice::heap(bodies, SPACING, 1.0);
    let margin = RADIUS - SPACING / 2.0 + 0.1;
    let container = Container::standing(
        lattice.half_width() + margin,
        lattice.height() + 2.0 * margin,
    );
    let elastic = |side: ColliderBuilder| side.restitution(1.0).friction(0.0).build();

    let mut world = floating();
    container.wall_in(&mut world, elastic);
    container.close(&mut world, elastic);
    for index in 0..bodies {
        let mut center = lattice.center(index) + jitter(random, 0.05);
        center[UP] += margin;
        let velocity = jitter(random, SPEED);
        world.insert(
            RigidBodyBuilder::dynamic()
                .translation(center)
                .linvel(velocity)
                .can_sleep(false),
            elastic(ColliderBuilder::ball(RADIUS).collision_groups(GHOSTS)),
        );
    }
    Stage::new(world, container)
}
