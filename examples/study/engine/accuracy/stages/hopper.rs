//! A hopper: grains run through a hole in a floor onto the floor below.

use super::{
    Case, ColliderBuilder, DIM, HALF_WALL, Jitter, Stage, UP, along, cells, columns, cuboid,
    falling, gauge, horizontal, insert, insert_room, place, plus, vector,
};

/// The mean radius of a grain; grains differ by a tenth either way.
const RADIUS: f64 = 0.5;

/// The distance of grains at the start.
const SPACING: f64 = 1.2;

/// How far a grain may be off its place at the start.
const JITTER: f64 = 0.04;

/// Half the width of the hole.
const HALF_HOLE: f64 = 2.0;

pub(super) fn build(case: &Case, jitter: &mut Jitter) -> Stage {
    let columns = columns(case.bodies).max(6);
    let layers = case.bodies.div_ceil(columns.pow(DIM as u32 - 1));
    let half_width = columns as f64 * SPACING / 2.0 + 0.1;
    // All grains find room below.
    let below = layers as f64 + 1.0;
    let mut world = falling();
    let height = below + 2.0 * HALF_WALL + (layers as f64 + 2.0) * SPACING;
    insert_room(&mut world, half_width, height, |wall| wall);
    for axis in horizontal() {
        for side in [-1.0, 1.0] {
            // Slabs along the second horizontal axis lie on those along the first, and end at the hole.
            let half = place(|other| match other {
                UP => HALF_WALL,
                other if other == axis => (half_width - HALF_HOLE) / 2.0,
                _ => half_width,
            });
            let center = plus(
                along(axis, side * (half_width + HALF_HOLE) / 2.0),
                along(UP, below + HALF_WALL),
            );
            let slab = cuboid(half).translation(vector(center)).friction(0.2);
            world.colliders.insert(slab);
        }
    }
    for (index, center) in cells(case.bodies, columns, SPACING).enumerate() {
        let radius = RADIUS * (0.9 + 0.05 * (index * 7 % 5) as f64);
        let grain = ColliderBuilder::ball(radius as _).friction(0.3);
        let shift = plus(along(UP, below + 2.0 * HALF_WALL), jitter.place(JITTER));
        insert(&mut world, plus(center, shift), grain);
    }
    let energy = gauge::energy_gained(&world);
    Stage::new(world)
        .with(gauge::penetration(2.0 * RADIUS))
        .with(gauge::outside(
            "grains that left through a wall, of all",
            move |place| {
                let is_beside = horizontal().any(|axis| place[axis].abs() > half_width);
                is_beside || place[UP] < 0.0
            },
        ))
        .with(energy)
}
