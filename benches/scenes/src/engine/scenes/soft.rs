//! Soft bodies in a heap with balls: Rapier's own where it has them, and otherwise balls on springs.

use super::*;

/// One body in this many is soft.
const SOFT_ONE_IN: usize = 10;
/// Half the size of a soft body.
const HALF: Real = 0.8;
/// The radius of a ball.
const RADIUS: Real = 0.5;
/// The distance between bodies at the start.
const SPACING: Real = 2.0;

pub(super) fn build(bodies: usize, random: &mut Random) -> Stage {
    // A soft body counts as what it is made of.
    let parts = version::PARTS_OF_SOFT_BODY;
    let soft = (bodies / (SOFT_ONE_IN - 1 + parts)).max(usize::from(bodies >= parts));
    let count = bodies - soft * (parts - 1);
    let lattice = Lattice::heap(count, SPACING, 1.0);
    let walls = Container::standing(lattice.half_width() + 0.5, lattice.height() + 2.0);
    let mut stage = Stage::walled(walls);
    for index in 0..count {
        let center = lattice.center(index) + along(UP, 0.5) + jitter(random, 0.05);
        if index % SOFT_ONE_IN == 0 && index / SOFT_ONE_IN < soft {
            version::insert_soft_body(&mut stage.world, center, HALF);
        } else {
            stage.insert(center, ColliderBuilder::ball(RADIUS));
        }
    }
    stage
}
