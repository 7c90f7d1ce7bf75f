//! Ropes of capsules that hang or fall over obstacles and tangle; and chains of capsules, each held at both ends, that slant
//! side by side. In 3D, every other row of chains swings the other way across their planes, so that they hit each other.
//!
//! Neighbours in a rope overlap at their joint, so that a broad phase reports them at every step although the joint disables
//! their contact. The box of a slanting link is mostly empty, so that it overlaps those of the chains beside it although no two
//! capsules touch: most pairs of boxes there are no contacts.

use super::*;

/// The number of capsules in a rope or chain.
const SEGMENTS: usize = 20;
/// The radius of a capsule.
const RADIUS: Real = 0.1;
/// The largest speed of a capsule at the start, along each axis.
const SPEED_OF_ROPE: Real = 0.5;
const SPEED_OF_CHAIN: Real = 0.3;
/// The largest speed at which a chain swings in 3D, along both horizontal axes.
const SWING: Real = 2.0;
/// The distance between ropes at the start, along every axis but the first.
const ROPES_APART: Real = 0.5;
/// The distance between chains along each horizontal axis, less than the box of a link is wide.
const CHAINS_APART: Real = 0.6;

/// By how much the first and the last link of a chain go down, to each unit that they go to the side.
///
/// In between it changes evenly from link to link: so a chain hangs that is held at both ends, a catenary.
const SLOPES: [Real; 2] = [1.6, 0.6];

/// A body, and the point of it where something is pinned to it.
type End = (RigidBodyHandle, Vector);

/// A capsule of a rope, and the point of it where the one before is pinned; the one after is pinned to the opposite point.
type Segment = (RigidBodyBuilder, ColliderBuilder, Vector);

/// Inserts segments, each pinned to the one before it, and the first to `held`. Returns the free end of the last.
fn insert_rope(
    stage: &mut Stage,
    held: Option<End>,
    segments: impl Iterator<Item = Segment>,
    length: Real,
) -> Option<End> {
    segments.fold(held, |previous, (body, capsule, near)| {
        let body = stage.world.insert(body, capsule);
        if let Some(end) = previous {
            stage.pin([end, (body, near)], length);
        }
        Some((body, -near))
    })
}

pub(super) fn build_ropes(bodies: usize, random: &mut Random) -> Stage {
    /// Half the distance between the two joints of a capsule.
    const HALF: Real = 0.25;
    let length = 2.0 * HALF * SEGMENTS as Real;
    let ropes = bodies.div_ceil(SEGMENTS);
    // Ropes lie side by side along the first axis, in layers: in the plane, one above the other.
    let width = match DIM {
        2 => 1,
        _ => ((ropes as Real).sqrt().ceil() as usize).max(1),
    };
    let layers = ropes.div_ceil(width).max(1);
    let half_width = (width as Real * ROPES_APART / 2.0).max(length) + 2.0;
    let walls = Container::standing(half_width, length + layers as Real * ROPES_APART);

    let mut stage = Stage::walled(walls);
    insert_obstacles(&mut stage.world, half_width, 3.0, random);
    for rope in 0..ropes {
        let across = (rope % width) as Real - (width - 1) as Real / 2.0;
        let start = vector(|axis| match axis {
            0 => -length / 2.0,
            UP => length * 0.6 + (rope / width) as Real * ROPES_APART,
            _ => across * ROPES_APART,
        }) + jitter(random, 0.05);
        // Every other rope hangs from its end.
        let held = (rope % 2 == 0).then(|| {
            let hook = RigidBodyBuilder::fixed().translation(start);
            (stage.world.bodies.insert(hook), Vector::default())
        });
        let segments = (0..SEGMENTS.min(bodies - rope * SEGMENTS)).map(|segment| {
            let body = RigidBodyBuilder::dynamic()
                .translation(start + along(0, (2 * segment + 1) as Real * HALF))
                .rotation(flavour::lying())
                .linvel(jitter(random, SPEED_OF_ROPE));
            // Lying turns the upper end of a capsule to the negative side of the first axis.
            (
                body,
                ColliderBuilder::capsule_y(HALF, RADIUS),
                along(UP, HALF),
            )
        });
        insert_rope(&mut stage, held, segments, 2.0 * HALF);
    }
    stage
}

pub(super) fn build_chains(bodies: usize, random: &mut Random) -> Stage {
    /// Half the distance between the two joints of a link.
    const HALF: Real = 0.5;
    let chains = bodies.div_ceil(SEGMENTS);
    let lattice = Lattice::layer(chains, CHAINS_APART);
    let mut stage = Stage::new(falling(), Container::above_ground());
    let frame = stage.world.bodies.insert(RigidBodyBuilder::fixed());
    let top = along(UP, 2.0 * HALF * SEGMENTS as Real);
    let sideways = 1.0 / (horizontal().count() as Real).sqrt();
    for chain in 0..chains {
        let start = lattice.center(chain) + top + jitter(random, 0.02);
        let mut joint = start;
        let swing = swing(chain % lattice.columns, random);
        let links = (0..SEGMENTS.min(bodies - chain * SEGMENTS)).map(|link| {
            let share = link as Real / (SEGMENTS - 1) as Real;
            let slope = SLOPES[0] + (SLOPES[1] - SLOPES[0]) * share;
            let half = direction(wide_high(sideways, -slope)) * HALF;
            let body = RigidBodyBuilder::dynamic()
                .translation(joint + half)
                .linvel(swing + jitter(random, SPEED_OF_CHAIN));
            joint += half * 2.0;
            let ends = [-half, half].map(Point::from);
            let link = ColliderBuilder::capsule_from_endpoints(ends[0], ends[1], RADIUS);
            (body, link, -half)
        });
        if let Some(end) = insert_rope(&mut stage, Some((frame, start)), links, 2.0 * HALF) {
            stage.pin([end, (frame, joint)], 2.0 * HALF);
        }
    }
    stage
}

/// A horizontal velocity across the plane of a chain in this row. A world of two dimensions has no such direction.
fn swing(row: usize, random: &mut Random) -> Vector {
    if DIM == 2 {
        return Vector::default();
    }
    let side = if row % 2 == 0 { 1.0 } else { -1.0 };
    let speed = side * random.range(SWING / 2.0, SWING);
    along(0, speed) - along(DIM - 1, speed)
}
