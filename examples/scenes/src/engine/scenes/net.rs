//! A net: balls joined to their neighbours in rows and columns, held at its edge, sagging over obstacles.
//!
//! Everything moves together and little, and most pairs that a broad phase reports are of joined neighbours.

use super::rapier::{math::DIM, prelude::*};
use super::{
    Container, Lattice, Point, Random, Stage, UP, Vector, World, along, falling, flavour, jitter,
    vector,
};

/// The radius of a knot.
const RADIUS: Real = 0.2;

/// The distance between joined knots.
const MESH: Real = 0.5;

/// In the plane, how many times as wide as high the net is, which hangs from its upper edge.
const ASPECT: usize = 4;

/// How far above the obstacles the net begins.
const HEIGHT: Real = 2.0;

/// The radius of an obstacle, and the distance between two.
const OBSTACLE: Real = 0.6;
const APART: Real = 4.0;

pub(super) fn build(bodies: usize, random: &mut Random) -> Stage {
    let columns = match DIM {
        2 => bodies * ASPECT,
        _ => bodies,
    };
    let columns = (columns.max(1) as f64).sqrt().ceil() as usize;
    let rows = bodies.max(1).div_ceil(columns);
    let half = [columns, rows].map(|count| count as Real * MESH / 2.0);
    let half_width = half[0].max(half[1]) + 2.0;
    let top = match DIM {
        2 => HEIGHT + 2.0 * half[1],
        _ => HEIGHT,
    };
    let walls = Container::standing(half_width, top + 2.0);
    let mut stage = Stage::new(falling(), walls.open());
    walls.wall_in(&mut stage.world, |side| side.build());
    insert_obstacles(&mut stage.world, half_width, random);

    // The second axis of the net: down in the plane, and otherwise to the side.
    let across = if DIM == 2 { UP } else { DIM - 1 };
    let place = |column: usize, row: usize| {
        vector(|axis| match axis {
            0 => (column as Real + 0.5) * MESH - half[0],
            _ if axis == across && DIM == 2 => top - (row as Real + 0.5) * MESH,
            _ if axis == across => (row as Real + 0.5) * MESH - half[1],
            _ => top,
        })
    };
    let mut knots: Vec<RigidBodyHandle> = Vec::with_capacity(bodies);
    for index in 0..bodies {
        let (column, row) = (index % columns, index / columns);
        let is_held = match DIM {
            2 => row == 0,
            _ => row == 0 || row + 1 >= rows || column == 0 || column + 1 == columns,
        };
        let knot = match is_held {
            true => RigidBodyBuilder::fixed(),
            false => RigidBodyBuilder::dynamic().linvel(jitter(random, 0.5)),
        };
        let knot = knot.translation(place(column, row));
        let knot = stage.world.insert(knot, ColliderBuilder::ball(RADIUS));
        if column > 0 {
            tie(&mut stage.world, [knots[index - 1], knot], along(0, MESH / 2.0));
        }
        if row > 0 {
            let half_mesh = (place(column, row) - place(column, row - 1)) / 2.0;
            tie(&mut stage.world, [knots[index - columns], knot], half_mesh);
        }
        knots.push(knot);
    }
    stage
}

/// Joins two knots half way between them.
fn tie(world: &mut World, knots: [RigidBodyHandle; 2], half_way: Vector) {
    let pin = GenericJointBuilder::new(flavour::PIN)
        .local_anchor1(Point::from(half_way))
        .local_anchor2(Point::from(-half_way))
        .contacts_enabled(false);
    world.impulse_joints.insert(knots[0], knots[1], pin, true);
}

/// Inserts fixed balls on the floor, which the net comes to lie over.
fn insert_obstacles(world: &mut World, half_width: Real, random: &mut Random) {
    let columns = ((2.0 * half_width / APART) as usize).max(1);
    let lattice = Lattice::with_columns(columns.pow(DIM as u32 - 1), APART, columns);
    for index in 0..lattice.per_layer() {
        let center = lattice.center(index) + jitter(random, 0.5);
        world
            .colliders
            .insert(ColliderBuilder::ball(OBSTACLE).translation(center));
    }
}
