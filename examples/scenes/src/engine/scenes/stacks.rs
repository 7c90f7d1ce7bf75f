//! Stacks: columns of boxes that stand so close that the boxes of neighbours nearly touch, and that touch nothing but
//! what is above and below.

use super::rapier::prelude::*;
use super::{Lattice, Random, Stage, UP, cube, horizontal};

/// Half the side of a box.
const HALF: Real = 0.5;

/// The distance between the middles of two columns, which leaves a gap of 0.05.
const SPACING: Real = 2.0 * HALF + 0.05;

/// How far a box may be off its place along each horizontal axis.
const OFFSET: Real = 0.002;

/// How high a column is: 22 x 22 of them are 6,776 boxes.
const HIGH: usize = 14;

pub(super) fn build(bodies: usize, random: &mut Random) -> Stage {
    let lattice = Lattice::layer(bodies.div_ceil(HIGH), SPACING);
    let mut stage = Stage::on_floor(lattice.half_width() + 10.0);
    for index in 0..bodies {
        let layer = index / lattice.per_layer();
        let mut center = lattice.center(index);
        center[UP] = (2.0 * layer as Real + 1.0) * HALF;
        for axis in horizontal() {
            center[axis] += random.range(-OFFSET, OFFSET);
        }
        stage.insert(center, cube(HALF));
    }
    stage
}
