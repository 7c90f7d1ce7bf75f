//! A pyramid of cuboids: deep contact chains that come to rest and fall asleep.

use super::rapier::{math::DIM, prelude::*};
use super::{Container, Random, Stage, UP, cube, cuboid, falling, horizontal, vector, wide_high};

/// Half the side of a cuboid.
const HALF: Real = 0.5;

/// The distance between neighbours in a layer.
const SPACING: Real = 1.1;

/// How far a cuboid may be off its place along each horizontal axis.
const OFFSET: Real = 0.01;

pub(super) fn build(bodies: usize, random: &mut Random) -> Stage {
    let mut base = 0;
    let mut count = 0;
    while count < bodies {
        base += 1;
        count += usize::pow(base, DIM as u32 - 1);
    }

    let mut world = falling();
    let half_floor = base as Real * SPACING + 10.0;
    world
        .colliders
        .insert(
            cuboid(wide_high(half_floor, 2.0)).translation(vector(|axis| match axis {
                UP => -2.0,
                _ => 0.0,
            })),
        );
    // The tip is cut off where the bodies run out.
    let mut left = bodies;
    for layer in 0..base {
        let side = base - layer;
        for index in 0..side.pow(DIM as u32 - 1).min(left) {
            let mut center = vector(|_| (2.0 * layer as Real + 1.0) * HALF);
            let mut rest = index;
            for axis in horizontal() {
                let place = (rest % side) as Real - (side - 1) as Real / 2.0;
                rest /= side;
                center[axis] = place * SPACING + random.range(-OFFSET, OFFSET);
            }
            world.insert(RigidBodyBuilder::dynamic().translation(center), cube(HALF));
            left -= 1;
        }
    }
    Stage::new(world, Container::above_ground())
}
