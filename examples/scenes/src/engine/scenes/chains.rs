//! Chains of capsules, each held at both ends, that slant side by side.
//!
//! The box of a slanting capsule is mostly empty, so that it overlaps those of the chains beside it although no two
//! capsules touch: a broad phase holds many pairs here that come to nothing.

use super::rapier::prelude::*;
use super::{
    Container, Lattice, Point, Random, Stage, UP, Vector, along, direction, falling, horizontal,
    jitter, wide_high,
};

/// The number of links of a chain.
const LINKS: usize = 20;

/// Half the distance between the two joints of a link.
const HALF: Real = 0.5;

/// The radius of a link.
const RADIUS: Real = 0.1;

/// The distance between chains along each horizontal axis, less than the box of a link is wide.
const APART: Real = 0.6;

/// By how much the first and the last link of a chain go down, to each unit that they go to the side.
///
/// In between it changes evenly from link to link: so a chain hangs that is held at both ends, a catenary.
const SLOPES: [Real; 2] = [1.6, 0.6];

/// The largest speed of a link at the start, along each axis.
const SPEED: Real = 0.3;

pub(super) fn build(bodies: usize, random: &mut Random) -> Stage {
    let chains = bodies.div_ceil(LINKS);
    let lattice = Lattice::layer(chains, APART);
    let mut stage = Stage::new(falling(), Container::above_ground());
    let frame = stage.world.bodies.insert(RigidBodyBuilder::fixed());
    let top = along(UP, 2.0 * HALF * LINKS as Real);
    for chain in 0..chains {
        let links = LINKS.min(bodies - chain * LINKS);
        let start = lattice.center(chain) + top + jitter(random, 0.02);
        insert_chain(&mut stage, frame, start, links, random);
    }
    stage
}

/// Inserts a chain that goes down from `start`, and holds both of its ends where they are.
fn insert_chain(
    stage: &mut Stage,
    frame: RigidBodyHandle,
    start: Vector,
    links: usize,
    random: &mut Random,
) {
    let mut joint = start;
    let mut previous = (frame, start);
    for link in 0..links {
        let share = link as Real / (LINKS - 1) as Real;
        let slope = SLOPES[0] + (SLOPES[1] - SLOPES[0]) * share;
        let sideways = 1.0 / (horizontal().count() as Real).sqrt();
        let half = direction(wide_high(sideways, -slope)) * HALF;
        let body = stage.world.insert(
            RigidBodyBuilder::dynamic()
                .translation(joint + half)
                .linvel(jitter(random, SPEED)),
            ColliderBuilder::capsule_from_endpoints(Point::from(-half), Point::from(half), RADIUS),
        );
        stage.pin([previous, (body, -half)], 2.0 * HALF);
        joint += half * 2.0;
        previous = (body, half);
    }
    stage.pin([previous, (frame, joint)], 2.0 * HALF);
}
