//! A hopper: grains that are poured into a funnel in batches, so that the number of bodies grows. They hit its sides and each
//! other from the first batch on, and leave through a narrow outlet.

use super::grains::{SPACING, grain};
use super::*;

/// The number of steps between two batches, in which the last one moves out of the way.
const INTERVAL: usize = 6;
/// The speed at which a batch starts to fall.
const SPEED: Real = 14.0;
/// Half the width of the outlet.
const HALF_OUTLET: Real = 2.5;
/// The slope of the funnel, in radians.
const SLOPE: Real = 0.8;

pub(super) fn build(bodies: usize, _random: &mut Random) -> Stage {
    let lattice = Lattice::heap(bodies, SPACING, 1.0);
    let half_width = lattice.half_width() + 1.0;
    // All grains find room below the outlet, and would find room above it.
    let outlet = lattice.height() * 0.9 + 2.0;
    let rim = outlet + half_width * SLOPE.tan();
    let walls = Container::standing(half_width, rim + lattice.height() + 2.0 * SPACING);
    let mut stage = Stage::walled(walls);
    for axis in horizontal() {
        for side in [-1.0, 1.0] {
            insert_panel(&mut stage.world, axis, side, outlet, half_width);
        }
    }
    // Pours a layer of grains every few steps until all are there. The spout rises with the grains, so that each layer starts
    // above the layers before it even if nothing has left the funnel.
    let mut left = bodies;
    let mut spout = rim;
    stage.with_script(move |world: &mut World, cue: &mut Cue| {
        if cue.step % INTERVAL != 0 {
            return;
        }
        let batch = lattice.per_layer().min(left);
        left -= batch;
        for index in 0..batch {
            let place = lattice.center(index) + along(UP, spout);
            let (center, ball) = grain(place, &mut cue.random);
            let body = RigidBodyBuilder::dynamic().translation(center);
            cue.insert(world, body.linvel(along(UP, -SPEED)), ball);
        }
        spout += SPACING;
    })
}

/// Inserts the panel of the funnel that leads from the outlet up to one of the walls.
fn insert_panel(world: &mut World, axis: usize, side: Real, outlet: Real, half_width: Real) {
    const HALF_THICKNESS: Real = 0.5;
    // Longer than needed, so that it ends inside of the wall.
    let half_length = (half_width - HALF_OUTLET + 2.0).max(1.0) / 2.0 / cosine(SLOPE);
    let half = vector(|other| match other {
        UP => HALF_THICKNESS,
        other if other == axis => half_length,
        _ => half_width + 1.0,
    });
    let lower = along(axis, side * HALF_OUTLET) + along(UP, outlet);
    let uphill = along(axis, side * cosine(SLOPE)) + along(UP, sine(SLOPE));
    world.colliders.insert(
        cuboid(half)
            .translation(lower + uphill * half_length)
            .rotation(flavour::tilt(axis, side * SLOPE))
            .friction(0.2),
    );
}
