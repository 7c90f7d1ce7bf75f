//! A map of fixed unit squares or cubes without gaps, as games build levels, on which a few balls fall.
//!
//! The tiles are solid ground of which only the top is ever touched. They never move, but each one borders on its
//! neighbours, and so nearly all pairs are of tiles, which the narrow phase drops.

use super::*;

/// Half the size of a tile.
const HALF: Real = 0.5;
/// How many tiles there are to a ball: with 500 balls 300 x 100, or 100 x 100 x 3.
const TILES_PER_BALL: usize = 60;
/// The radius of a ball.
const RADIUS: Real = 0.45;
/// The largest speed of a ball along each axis.
const SPEED: Real = 0.4;
/// The angular damping of a ball, so that none rolls off the map.
const DAMPING: Real = 5.0;
/// The share of the map's width above which balls fall.
const SHARE: Real = 0.7;
/// How many layers of balls there are, so that they land at different times.
const LAYERS: usize = 4;
/// The distance between layers, wide enough for their balls.
const LAYER: Real = 2.0;

pub(super) fn build(bodies: usize, random: &mut Random) -> Stage {
    // Three times as wide as deep in the plane, three deep in space.
    let side = power((bodies.max(1) * TILES_PER_BALL / 3) as Real, 0.5).round() as usize;
    let (columns, depth) = match DIM {
        2 => (3 * side, side),
        _ => (side, 3),
    };
    let map = Lattice::with_columns(columns.pow(DIM as u32 - 1) * depth, 2.0 * HALF, columns);
    let mut stage = Stage::new(falling(), Container::above_ground());
    for index in 0..map.layers * map.per_layer() {
        let mut center = map.center(index);
        center[UP] -= map.height();
        let tile = cube(HALF).translation(center);
        stage.world.colliders.insert(tile);
    }

    let per_layer = bodies.div_ceil(LAYERS).max(1);
    let balls_across = power(per_layer as Real, 1.0 / (DIM - 1) as Real).ceil();
    let spacing = (2.0 * map.half_width() * SHARE / balls_across).max(2.5 * RADIUS);
    let lattice = Lattice::with_columns(bodies, spacing, balls_across as usize);
    for index in 0..bodies {
        let mut center = lattice.center(index);
        center[UP] = 2.0 * RADIUS + (index / lattice.per_layer()) as Real * LAYER;
        let velocity = jitter(random, SPEED);
        let ball = RigidBodyBuilder::dynamic()
            .translation(center + jitter(random, 0.05))
            .linvel(velocity)
            .angular_damping(DAMPING);
        stage.world.insert(ball, ColliderBuilder::ball(RADIUS));
    }
    stage
}
