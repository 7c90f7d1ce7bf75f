//! A uniform gas: elastic balls in a closed box, the case that the analysis of a sweep assumes.

use super::rapier::{math::DIM, prelude::*};
use super::{Container, Lattice, Random, Stage, flavour, floating, jitter, power};

/// The radius of every ball.
const RADIUS: Real = 0.5;

/// The share of the box that is inside of balls.
const DENSITY: Real = 0.2;

/// The largest speed along each axis, in length units per second.
const SPEED: Real = 5.0;

pub(super) fn build(bodies: usize, random: &mut Random) -> Stage {
    let ball = flavour::UNIT_BALL * RADIUS.powi(DIM as i32);
    let spacing = power(ball / DENSITY, 1.0 / DIM as Real);
    let lattice = Lattice::heap(bodies, spacing, 1.0);
    let container = Container::standing(lattice.half_width(), lattice.height());
    let elastic = |side: ColliderBuilder| side.restitution(1.0).friction(0.0).build();

    let mut world = floating();
    container.wall_in(&mut world, elastic);
    container.close(&mut world, elastic);
    for index in 0..bodies {
        let center = lattice.center(index) + jitter(random, spacing / 2.0 - RADIUS);
        let velocity = jitter(random, SPEED);
        world.insert(
            RigidBodyBuilder::dynamic()
                .translation(center)
                .linvel(velocity)
                .can_sleep(false),
            elastic(ColliderBuilder::ball(RADIUS)),
        );
    }
    Stage::new(world, container)
}
