//! Balls falling into a box: the plain case of a pile in which nearly everything touches.

use super::rapier::prelude::*;
use super::{Container, Lattice, Random, Stage, falling, jitter};

/// Radii differ by a tenth either way.
const RADIUS: [Real; 2] = [0.45, 0.55];

/// The distance between two balls at the start, wide enough for the largest with the jitter.
const SPACING: Real = 1.25;

pub(super) fn build(bodies: usize, random: &mut Random) -> Stage {
    let lattice = Lattice::heap(bodies, SPACING, 1.0);
    let container = Container::standing(lattice.half_width() + 0.5, lattice.height() + 1.0).open();
    let mut world = falling();
    let walls = Container::standing(lattice.half_width() + 0.5, lattice.height() + 1.0);
    walls.wall_in(&mut world, |side| side.build());
    for index in 0..bodies {
        let center = lattice.center(index) + jitter(random, 0.07);
        let radius = random.range(RADIUS[0], RADIUS[1]);
        world.insert(
            RigidBodyBuilder::dynamic().translation(center),
            ColliderBuilder::ball(radius),
        );
    }
    Stage::new(world, container)
}
