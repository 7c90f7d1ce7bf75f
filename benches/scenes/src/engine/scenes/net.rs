//! A net: balls joined to their neighbours in rows and columns, held at its edge, sagging over obstacles.
//!
//! Everything moves together and little, and most pairs that a broad phase reports are of joined neighbours.

use super::*;

/// The radius of a knot.
const RADIUS: Real = 0.2;
/// The distance between joined knots.
const MESH: Real = 0.5;
/// What share of its speed a knot loses in a second, about: the yarn gives.
const DAMPING: Real = 0.5;
/// In the plane, how many times as wide as high the net is, which hangs from its upper edge.
const ASPECT: usize = 4;
/// How far above the obstacles the net begins.
const HEIGHT: Real = 2.0;

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
    let mut stage = Stage::walled(walls);
    insert_obstacles(&mut stage.world, half_width, 4.0, random);

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
    let yarn = RopeJointBuilder::new(MESH);
    let frame = stage.world.bodies.insert(RigidBodyBuilder::fixed());
    let mut knots: Vec<RigidBodyHandle> = Vec::with_capacity(bodies);
    // Those at the edge are held where they are; there is no tie between two of them.
    let is_held = |column: usize, row: usize| match DIM {
        2 => row == 0,
        _ => row == 0 || row + 1 >= rows || column == 0 || column + 1 == columns,
    };
    for index in 0..bodies {
        let (column, row) = (index % columns, index / columns);
        let center = place(column, row);
        let knot = RigidBodyBuilder::dynamic()
            .translation(center)
            .linvel(jitter(random, 0.1))
            .linear_damping(DAMPING)
            .angular_damping(DAMPING);
        let knot = stage.world.insert(knot, ColliderBuilder::ball(RADIUS));
        let ties = &mut stage.world.impulse_joints;
        let is_at_edge = is_held(column, row);
        if is_at_edge {
            let hook = GenericJointBuilder::new(flavour::PIN).local_anchor1(Point::from(center));
            ties.insert(frame, knot, hook, true);
        }
        if column > 0 && !(is_at_edge && is_held(column - 1, row)) {
            ties.insert(knots[index - 1], knot, yarn, true);
        }
        if row > 0 && !(is_at_edge && is_held(column, row - 1)) {
            ties.insert(knots[index - columns], knot, yarn, true);
        }
        knots.push(knot);
    }
    stage
}
