//! Ropes: chains of capsules that hang or fall over obstacles and tangle.
//!
//! Neighbours in a chain overlap at their joint, so that a broad phase reports them at every step although
//! the joint disables their contact.

use super::rapier::{math::DIM, prelude::*};
use super::{
    Container, Random, Stage, UP, Vector, along, flavour, insert_obstacles, jitter, vector,
};

/// The number of capsules in a rope.
const SEGMENTS: usize = 20;

/// Half the distance between the two joints of a capsule.
const HALF: Real = 0.25;

/// The radius of a capsule.
const RADIUS: Real = 0.1;

/// The distance between ropes at the start, along every axis but the first.
const SPACING: Real = 0.5;

pub(super) fn build(bodies: usize, random: &mut Random) -> Stage {
    let length = 2.0 * HALF * SEGMENTS as Real;
    let ropes = bodies.div_ceil(SEGMENTS);
    // Ropes lie side by side along the first axis, in layers: in the plane, one above the other.
    let width = match DIM {
        2 => 1,
        _ => ((ropes as Real).sqrt().ceil() as usize).max(1),
    };
    let layers = ropes.div_ceil(width).max(1);
    let half_width = (width as Real * SPACING / 2.0).max(length) + 2.0;
    let walls = Container::standing(half_width, length + layers as Real * SPACING);

    let mut stage = Stage::walled(walls);
    insert_obstacles(&mut stage.world, half_width, 3.0, random);
    for rope in 0..ropes {
        let segments = SEGMENTS.min(bodies - rope * SEGMENTS);
        let across = (rope % width) as Real - (width - 1) as Real / 2.0;
        let start = vector(|axis| match axis {
            0 => -length / 2.0,
            UP => length * 0.6 + (rope / width) as Real * SPACING,
            _ => across * SPACING,
        }) + jitter(random, 0.05);
        // Every other rope hangs from its end.
        insert_rope(&mut stage, start, segments, rope % 2 == 0, random);
    }
    stage
}

/// Inserts a rope that lies along the first axis from `start` on.
fn insert_rope(
    stage: &mut Stage,
    start: Vector,
    segments: usize,
    hangs: bool,
    random: &mut Random,
) {
    let mut previous = hangs.then(|| {
        let hook = RigidBodyBuilder::fixed().translation(start);
        (stage.world.bodies.insert(hook), Vector::default())
    });
    for segment in 0..segments {
        let along_rope = (2 * segment + 1) as Real * HALF;
        let body = stage.world.insert(
            RigidBodyBuilder::dynamic()
                .translation(start + along(0, along_rope))
                .rotation(flavour::lying())
                .linvel(jitter(random, 0.5)),
            ColliderBuilder::capsule_y(HALF, RADIUS),
        );
        // Lying turns the upper end of a capsule to the negative side of the first axis.
        let upper = along(UP, HALF);
        if let Some(end) = previous {
            stage.pin([end, (body, upper)], 2.0 * HALF);
        }
        previous = Some((body, -upper));
    }
}
