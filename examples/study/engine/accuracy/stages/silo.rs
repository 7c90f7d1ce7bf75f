//! A silo: grains at rest between walls without friction, so that the floor bears all of their weight.

use super::CoefficientCombineRule::Min;
use super::{
    Case, ColliderBuilder, DIM, Jitter, RigidBodyBuilder, Stage, cells, falling, gauge,
    insert_room, plus, vector,
};

/// The mean radius of a grain; grains differ by a tenth either way.
const RADIUS: f64 = 0.5;

/// The distance of grains at the start.
const SPACING: f64 = 1.1;

/// How far a grain may be off its place at the start.
const JITTER: f64 = 0.03;

/// The part of the time after which the grains rest.
const AT_REST: f64 = 0.6;

pub(super) fn build(case: &Case, jitter: &mut Jitter) -> Stage {
    let columns = match DIM {
        2 => 8,
        _ => 4,
    };
    let layers = case.bodies.div_ceil(columns_in(columns));
    let mut world = falling();
    let half_width = columns as f64 * SPACING / 2.0 + 0.05;
    let height = (layers + 2) as f64 * SPACING;
    let smooth = |wall: ColliderBuilder| wall.friction(0.0).friction_combine_rule(Min);
    let floor = insert_room(&mut world, half_width, height, smooth);
    for (index, center) in cells(case.bodies, columns, SPACING).enumerate() {
        let radius = RADIUS * (0.9 + 0.05 * (index * 7 % 5) as f64);
        // A sleeping grain bears nothing.
        let grain = RigidBodyBuilder::dynamic()
            .can_sleep(false)
            .translation(vector(plus(center, jitter.place(JITTER))));
        world.insert(grain, ColliderBuilder::ball(radius as _));
    }
    let from = AT_REST * case.seconds;
    Stage::new(world)
        .with(gauge::weight(floor).from(from))
        .with(gauge::penetration(2.0 * RADIUS).from(from))
}

fn columns_in(columns: usize) -> usize {
    columns.pow(DIM as u32 - 1)
}
