//! Boxes that come to rest. Pyramids of cubes, one or many, have deep or shallow chains of contacts. Columns stand so close that a
//! broad phase pairs the boxes of neighbours, which never touch; stacks stand so far apart that every pair is a contact. A brick
//! wall in running bond starts and ends every other course with half a brick; in 3D it is one brick thick. A heap is what becomes
//! of cubes that are dropped on a floor.

use super::*;

/// Half the side of a cube.
const HALF: Real = 0.5;
/// The distance between neighbours in a layer of a pyramid.
const PYRAMID_SPACING: Real = 1.1;
/// How many cubes wide one of many pyramids is. Of either dimension it has [`SMALL`] cubes.
const SMALL_BASE: usize = if DIM == 2 { 10 } else { 5 };
const SMALL: usize = 55;
/// The distance between two of many pyramids, from middle to middle.
const APART: Real = SMALL_BASE as Real * PYRAMID_SPACING + 2.0;
/// Columns leave a gap of 0.05; 22 x 22 of them are 6,776 boxes.
pub(super) const COLUMNS: Towers = Towers {
    spacing: 2.0 * HALF + 0.05,
    height: 14,
};
/// Stacks leave a gap of a box; 25 x 25 of them are 6,250 boxes.
pub(super) const STACKS: Towers = Towers {
    spacing: 4.0 * HALF,
    height: 10,
};
/// Half the height of a brick, and half its depth in space.
const HALF_HEIGHT: Real = 0.25;
const HALF_DEPTH: Real = 0.5;
/// The length of half a brick with its joint.
const UNIT: Real = 0.51;
/// The width of a joint, which stays open.
const JOINT: Real = 0.02;
/// How many times as many bricks are in a course as there are courses.
const ASPECT: usize = 6;
/// How far a cube or a brick may be off its place along each horizontal axis.
const PYRAMID_OFFSET: Real = 0.01;
const TOWER_OFFSET: Real = 0.002;
const WALL_OFFSET: Real = 0.004;

/// Boxes on top of each other, again and again.
#[derive(Clone, Copy)]
pub(super) struct Towers {
    /// The distance between the middles of neighbours.
    spacing: Real,
    /// The number of boxes in a tower.
    height: usize,
}

/// Builds one pyramid of all bodies.
pub(super) fn build_pyramid(bodies: usize, random: &mut Random) -> Stage {
    let mut base = 0;
    let mut count = 0;
    while count < bodies {
        base += 1;
        count += usize::pow(base, DIM as u32 - 1);
    }

    let mut stage = Stage::on_floor(base as Real * PYRAMID_SPACING + 10.0);
    insert_pyramid(&mut stage, Vector::default(), base, bodies, random);
    stage
}

/// Builds small pyramids side by side, in a row or in rows.
pub(super) fn build_pyramids(bodies: usize, random: &mut Random) -> Stage {
    let pyramids = bodies.div_ceil(SMALL);
    let lattice = Lattice::layer(pyramids, APART);
    let mut stage = Stage::on_floor(lattice.half_width() + 10.0);
    for pyramid in 0..pyramids {
        let mut middle = lattice.center(pyramid);
        middle[UP] = 0.0;
        let cubes = SMALL.min(bodies - pyramid * SMALL);
        insert_pyramid(&mut stage, middle, SMALL_BASE, cubes, random);
    }
    stage
}

/// Inserts a pyramid. Its tip is cut off where the cubes run out.
fn insert_pyramid(
    stage: &mut Stage,
    middle: Vector,
    base: usize,
    cubes: usize,
    random: &mut Random,
) {
    let mut left = cubes;
    for layer in 0..base {
        let side = base - layer;
        for index in 0..side.pow(DIM as u32 - 1).min(left) {
            let mut center = vector(|_| (2.0 * layer as Real + 1.0) * HALF);
            let mut rest = index;
            for axis in horizontal() {
                let place = (rest % side) as Real - (side - 1) as Real / 2.0;
                rest /= side;
                let offset = random.range(-PYRAMID_OFFSET, PYRAMID_OFFSET);
                center[axis] = place * PYRAMID_SPACING + offset + middle[axis];
            }
            stage.insert(center, cube(HALF));
            left -= 1;
        }
    }
}

/// Builds towers side by side, in a row or in rows.
pub(super) fn build_towers(bodies: usize, towers: Towers, random: &mut Random) -> Stage {
    let lattice = Lattice::layer(bodies.div_ceil(towers.height), towers.spacing);
    let mut stage = Stage::on_floor(lattice.half_width() + 10.0);
    for index in 0..bodies {
        let layer = index / lattice.per_layer();
        let mut center = lattice.center(index);
        center[UP] = (2.0 * layer as Real + 1.0) * HALF;
        for axis in horizontal() {
            center[axis] += random.range(-TOWER_OFFSET, TOWER_OFFSET);
        }
        stage.insert(center, cube(HALF));
    }
    stage
}

pub(super) fn build_wall(bodies: usize, random: &mut Random) -> Stage {
    let columns = ((bodies.max(1) * ASPECT) as f64).sqrt().ceil() as usize;
    let half_width = columns as Real * UNIT;
    let mut stage = Stage::on_floor(half_width + 10.0);
    for index in 0..bodies {
        // Courses have `columns` bricks and one more by turns. A brick begins and ends at these halves of bricks.
        let (two_courses, place) = (index / (2 * columns + 1), index % (2 * columns + 1));
        let (course, start, end) = match place.checked_sub(columns) {
            None => (2 * two_courses, 2 * place, 2 * place + 2),
            Some(place) => (
                2 * two_courses + 1,
                (2 * place).max(1) - 1,
                (2 * place + 1).min(2 * columns),
            ),
        };
        let offset = random.range(-WALL_OFFSET, WALL_OFFSET);
        let center = vector(|axis| match axis {
            0 => (start + end) as Real * UNIT / 2.0 - half_width + offset,
            UP => (2.0 * course as Real + 1.0) * HALF_HEIGHT,
            _ => 0.0,
        });
        let half = vector(|axis| match axis {
            0 => ((end - start) as Real * UNIT - JOINT) / 2.0,
            UP => HALF_HEIGHT,
            _ => HALF_DEPTH,
        });
        stage.insert(center, cuboid(half));
    }
    stage
}

/// Drops cubes, turned at random, on a floor that is wide enough for all that roll away.
pub(super) fn build_heap(bodies: usize, random: &mut Random) -> Stage {
    // A turned cube needs no more than the spacing.
    let spacing = 2.0 * HALF * (DIM as Real).sqrt();
    let lattice = Lattice::heap(bodies, spacing, 0.5);
    let mut stage = Stage::on_floor(2.0 * lattice.half_width() + 2.0 * lattice.height() + 10.0);
    for index in 0..bodies {
        let turn = flavour::turning(|| random.range(-1.0, 1.0));
        let body = RigidBodyBuilder::dynamic()
            .translation(lattice.center(index))
            .rotation(turn);
        stage.world.insert(body, cube(HALF));
    }
    stage
}
