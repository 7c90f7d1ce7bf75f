//! A pile: balls and boxes in turns, which fall into a walled box and come to rest.

use super::{
    Case, ColliderBuilder, Jitter, Stage, cells, columns, cuboid, falling, gauge, insert,
    insert_room, place, plus,
};

/// The radius of a ball, and half the side of a box.
const HALF: f64 = 0.5;

/// The distance of neighbours at the start.
const SPACING: f64 = 1.1;

/// How far a body may be off its place at the start.
const JITTER: f64 = 0.04;

/// The part of the time after which it should rest.
const AT_REST: f64 = 0.6;

pub(super) fn build(case: &Case, jitter: &mut Jitter) -> Stage {
    let columns = columns(case.bodies);
    let mut world = falling();
    let height = 2.0 * columns as f64 * SPACING;
    insert_room(
        &mut world,
        (columns as f64 + 0.6) * SPACING / 2.0,
        height,
        |wall| wall,
    );
    for (index, center) in cells(case.bodies, columns, SPACING).enumerate() {
        let shape = match index % 2 {
            0 => ColliderBuilder::ball(HALF as _),
            _ => cuboid(place(|_| HALF)),
        };
        insert(&mut world, plus(center, jitter.place(JITTER)), shape);
    }
    let energy = gauge::energy_gained(&world);
    Stage::new(world)
        .with(gauge::penetration(2.0 * HALF).from(AT_REST * case.seconds))
        .with(gauge::rest().from(AT_REST * case.seconds))
        .with(energy)
}
