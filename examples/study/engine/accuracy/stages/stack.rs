//! Towers of boxes, which should stand where they were built.

use super::{
    Case, DIM, Jitter, Stage, cuboid, falling, gauge, horizontal, insert, insert_floor, place,
};

/// Half the side of a box.
const HALF: f64 = 0.5;

/// The boxes of a tower.
const LEVELS: usize = 10;

/// The distance of two towers.
const SPACING: f64 = 3.0;

/// How far a box may be off the axis of its tower.
const JITTER: f64 = 0.02;

pub(super) fn build(case: &Case, jitter: &mut Jitter) -> Stage {
    let towers = case.bodies.div_ceil(LEVELS);
    let side = match DIM {
        2 => towers,
        _ => (towers as f64).sqrt().ceil() as usize,
    };
    let mut world = falling();
    insert_floor(&mut world, (side + 1) as f64 * SPACING, |floor| floor);
    for tower in 0..towers {
        for level in 0..LEVELS {
            let mut center = place(|_| (2 * level + 1) as f64 * HALF);
            for (axis, cell) in horizontal().zip([tower % side, tower / side]) {
                let middle = (side - 1) as f64 / 2.0;
                center[axis] = (cell as f64 - middle) * SPACING + jitter.by(JITTER);
            }
            insert(&mut world, center, cuboid(place(|_| HALF)));
        }
    }
    let places = gauge::displacement(&world, 2.0 * HALF);
    Stage::new(world)
        .with(places)
        .with(gauge::penetration(2.0 * HALF))
}
