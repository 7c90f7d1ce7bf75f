//! Bodies of mixed sizes, falling onto half-spaces, whose boxes are as large as boxes get.
//!
//! For a broad phase that is made for boxes of about the same size, a ratio of 1.5 is easy, 4 and 8 are work, and at
//! 1,000 the few large ones need separate treatment.

use super::*;

/// The sizes of the last scene: most bodies are near the lower end.
const GRAIN: [Real; 2] = [0.05, 0.5];
/// The sizes of the hills of the last scene.
const HILL: [Real; 2] = [2.0, 50.0];
/// By how much a hill rises above the ground.
const RISE: [Real; 2] = [0.3, 1.0];
/// One hill to this many bodies.
const BODIES_PER_HILL: usize = 100;

/// Builds a wide heap on one half-space, of balls and cubes whose sizes differ by up to `ratio`.
pub(super) fn build_heap(bodies: usize, ratio: Real, random: &mut Random) -> Stage {
    let sizes = [0.5 / ratio.sqrt(), 0.5 * ratio.sqrt()];
    // A turned cube needs no more than the spacing, so that nothing overlaps at the start.
    let lattice = Lattice::heap(bodies, 2.0 * sizes[1] * 1.1, 0.3);
    let container = Container::above_ground();
    let mut stage = Stage::new(falling(), container);
    container.dig(&mut stage.world);
    for index in 0..bodies {
        let center = lattice.center(index) + jitter(random, 0.04);
        let half = log_range(random, sizes[0], sizes[1]);
        stage.insert(center, ball_or_cube(index, half));
    }
    stage
}

/// Builds a pit of half-spaces with hills, of which only the tops show, and grains falling onto them.
///
/// The large ones are fixed: a solver does not cope with a body that is a billion times heavier than the
/// one below it.
pub(super) fn build_hills(bodies: usize, random: &mut Random) -> Stage {
    let hills = bodies.div_ceil(BODIES_PER_HILL).min(bodies / 2);
    let grains = bodies - hills;
    let lattice = Lattice::heap(grains, 2.0 * GRAIN[1] * 1.1, 0.2);
    let half_width = lattice.half_width() + 0.5;
    let container = Container::standing(half_width, lattice.height()).open();
    let mut stage = Stage::new(falling(), container);
    container.dig(&mut stage.world);

    for hill in 0..hills {
        // The first hill is the largest and the first grain the smallest, so that the ratio is as named.
        let radius = match hill {
            0 => HILL[1],
            _ => log_range(random, HILL[0], HILL[1]),
        };
        let mut center = Vector::default();
        for axis in horizontal() {
            center[axis] = random.range(-half_width, half_width);
        }
        center[UP] = random.range(RISE[0], RISE[1]) - radius;
        let body = RigidBodyBuilder::fixed().translation(center);
        stage.world.insert(body, ColliderBuilder::ball(radius));
    }
    for index in 0..grains {
        let mut center = lattice.center(index) + jitter(random, 0.03);
        center[UP] += RISE[1];
        // A product of two draws makes small ones frequent.
        let half = match index {
            0 => GRAIN[0],
            _ => log_range(random, GRAIN[0], GRAIN[1]).min(log_range(random, GRAIN[0], GRAIN[1])),
        };
        stage.insert(center, ball_or_cube(index, half));
    }
    stage
}

/// Balls and cubes by turns.
fn ball_or_cube(index: usize, half: Real) -> ColliderBuilder {
    match index % 2 {
        0 => ColliderBuilder::ball(half),
        _ => cube(half),
    }
}
