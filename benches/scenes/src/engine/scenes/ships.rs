//! Ships: three rigid bodies of very many cubes each, which drift and turn without gravity.
//!
//! All cubes of a ship move together, and the narrow phase drops their pairs. In the middle of each ship a cube is
//! left out, where a ball lies as cargo, so that a few pairs are worth something.

use super::*;

/// Half the size of a cube.
const HALF: Real = 0.5;
/// The radius of the cargo.
const CARGO: Real = 0.45;
/// The number of ships.
const SHIPS: usize = 3;
/// The largest speed along each axis, slow enough that ships stay apart.
const SPEED: Real = 0.5;
/// The largest rate of turning, in radians per second.
const TURN: Real = 0.2;

/// Builds ships of `colliders` in all, cargo included: cubes in space, squares in the plane.
pub(super) fn build(colliders: usize, random: &mut Random) -> Stage {
    let mut side = 1;
    while SHIPS * usize::pow(side, DIM as u32) < colliders {
        side += 1;
    }
    // A ship that turns stays within the circle around it.
    let apart = 2.0 * side as Real + 10.0;
    let room = Container::standing(2.0 * apart, 2.0 * apart);
    let mut world = floating();
    for ship in 0..SHIPS {
        let cells = (colliders + ship) / SHIPS;
        if cells == 0 {
            continue;
        }
        let hull = Lattice::with_columns(cells, 2.0 * HALF, side);
        let mut place = jitter(random, 0.5);
        place[0] += (ship as Real - 1.0) * apart;
        place[UP] += apart;
        let velocity = jitter(random, SPEED);
        let body = world.bodies.insert(
            RigidBodyBuilder::dynamic()
                .translation(place)
                .linvel(velocity)
                .angvel(flavour::turning(|| random.range(-TURN, TURN)))
                .can_sleep(false),
        );
        let hold = hold(&hull, cells);
        for index in 0..cells {
            // A hull turns around its middle.
            let center = hull.center(index) - along(UP, hull.height() / 2.0);
            if index == hold {
                world.insert(
                    RigidBodyBuilder::dynamic()
                        .translation(place + center)
                        .linvel(velocity)
                        .can_sleep(false),
                    ColliderBuilder::ball(CARGO),
                );
            } else {
                world.colliders.insert_with_parent(
                    cube(HALF).translation(center),
                    body,
                    &mut world.bodies,
                );
            }
        }
    }
    Stage::new(world, room)
}

/// The different hulls of the single body, the largest distance of each from the middle along each axis, and the rate of turning.
const HULLS: usize = 17;
const ASIDE: Real = 2.0;
const SPIN: Real = 1.0;

/// Builds a body of `colliders` in all, which turns alone in space.
pub(super) fn build_one(colliders: usize, random: &mut Random) -> Stage {
    let mut world = floating();
    let turning = RigidBodyBuilder::dynamic()
        .translation(along(UP, 2.0 * ASIDE))
        .angvel(flavour::turning(|| SPIN))
        .can_sleep(false);
    let body = world.bodies.insert(turning);
    let hull = |_| shapes::convex(random).translation(jitter(random, ASIDE));
    let hulls: Vec<_> = (0..HULLS).map(hull).collect();
    for hull in hulls.into_iter().cycle().take(colliders) {
        world
            .colliders
            .insert_with_parent(hull, body, &mut world.bodies);
    }
    Stage::new(world, Container::standing(3.0 * ASIDE, 5.0 * ASIDE))
}

/// The cell of the cargo, in the middle; none of a ship that is too small to keep it in.
fn hold(hull: &Lattice, cells: usize) -> usize {
    let full_layers = cells / hull.per_layer();
    if hull.columns < 3 || full_layers < 3 {
        return cells;
    }
    let column = (hull.columns - 1) / 2;
    let in_layer: usize = (0..DIM as u32 - 1)
        .map(|axis| column * hull.columns.pow(axis))
        .sum();
    in_layer + (full_layers - 1) / 2 * hull.per_layer()
}
