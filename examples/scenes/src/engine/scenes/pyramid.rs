//! Pyramids of cuboids, one or many: contact chains, deep or shallow, that come to rest and fall asleep.

use super::rapier::{math::DIM, prelude::*};
use super::{Lattice, Random, Stage, UP, Vector, cube, horizontal, vector};

/// Half the side of a cuboid.
const HALF: Real = 0.5;

/// The distance between neighbours in a layer.
const SPACING: Real = 1.1;

/// How far a cuboid may be off its place along each horizontal axis.
const OFFSET: Real = 0.01;

/// How many cuboids wide one of many pyramids is. Of either dimension it has [`SMALL`] cuboids.
const SMALL_BASE: usize = if DIM == 2 { 10 } else { 5 };
const SMALL: usize = 55;

/// The distance between two of many pyramids, from middle to middle.
const APART: Real = SMALL_BASE as Real * SPACING + 2.0;

/// Builds one pyramid of all bodies.
pub(super) fn build_one(bodies: usize, random: &mut Random) -> Stage {
    let mut base = 0;
    let mut count = 0;
    while count < bodies {
        base += 1;
        count += usize::pow(base, DIM as u32 - 1);
    }

    let mut stage = Stage::on_floor(base as Real * SPACING + 10.0);
    insert_pyramid(&mut stage, Vector::default(), base, bodies, random);
    stage
}

/// Builds small pyramids side by side, in a row or in rows.
pub(super) fn build_many(bodies: usize, random: &mut Random) -> Stage {
    let pyramids = bodies.div_ceil(SMALL);
    let lattice = Lattice::layer(pyramids, APART);
    let mut stage = Stage::on_floor(lattice.half_width() + 10.0);
    for pyramid in 0..pyramids {
        let mut middle = lattice.center(pyramid);
        middle[UP] = 0.0;
        let cuboids = SMALL.min(bodies - pyramid * SMALL);
        insert_pyramid(&mut stage, middle, SMALL_BASE, cuboids, random);
    }
    stage
}

/// Inserts a pyramid. Its tip is cut off where the cuboids run out.
fn insert_pyramid(
    stage: &mut Stage,
    middle: Vector,
    base: usize,
    cuboids: usize,
    random: &mut Random,
) {
    let mut left = cuboids;
    for layer in 0..base {
        let side = base - layer;
        for index in 0..side.pow(DIM as u32 - 1).min(left) {
            let mut center = vector(|_| (2.0 * layer as Real + 1.0) * HALF);
            let mut rest = index;
            for axis in horizontal() {
                let place = (rest % side) as Real - (side - 1) as Real / 2.0;
                rest /= side;
                center[axis] = place * SPACING + random.range(-OFFSET, OFFSET) + middle[axis];
            }
            stage.insert(center, cube(HALF));
            left -= 1;
        }
    }
}
