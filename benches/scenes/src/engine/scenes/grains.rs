//! Grains: balls of about the same size, of which several scenes are made. The plainest of these is a heap that falls into a box, in
//! which nearly everything touches.

use super::*;

/// Radii differ by a tenth either way.
const RADIUS: [Real; 2] = [0.45, 0.55];
/// The distance between two grains at the start, wide enough for the largest with the jitter.
pub(super) const SPACING: Real = 1.25;

/// The center and the shape of a grain in a cell.
pub(super) fn grain(cell: Vector, random: &mut Random) -> (Vector, ColliderBuilder) {
    let center = cell + jitter(random, 0.07);
    let radius = random.range(RADIUS[0], RADIUS[1]);
    (center, ColliderBuilder::ball(radius))
}

pub(super) fn build(bodies: usize, random: &mut Random) -> Stage {
    let lattice = Lattice::heap(bodies, SPACING, 1.0);
    let walls = Container::standing(lattice.half_width() + 0.5, lattice.height() + 1.0);
    let mut stage = Stage::walled(walls);
    for index in 0..bodies {
        let (center, ball) = grain(lattice.center(index), random);
        stage.insert(center, ball);
    }
    stage
}
