//! Elastic balls in a closed box without gravity. In a gas they are uniform, the case that the analysis of a sweep assumes. Ghosts
//! overlap and do not meet each other, only the walls: pairs of which the narrow phase makes nothing, a dozen to a ghost.

use super::*;

/// The radius of every ball.
const RADIUS: Real = 0.5;
/// The share of the box that is inside of balls of a gas.
const DENSITY: Real = 0.2;

/// What meets everything but its own kind.
pub(super) const GHOSTS: InteractionGroups =
    version::groups(Group::GROUP_2, Group::ALL.difference(Group::GROUP_2));

/// How balls fill a box.
struct Filling {
    /// The distance between balls at the start.
    spacing: Real,
    /// How far a ball may be off its place along each axis.
    offset: Real,
    /// The distance from the walls beyond half the spacing.
    margin: Real,
    /// The largest speed along each axis, in length units per second.
    speed: Real,
    ball: ColliderBuilder,
}

pub(super) fn build(bodies: usize, random: &mut Random) -> Stage {
    let ball = flavour::UNIT_BALL * RADIUS.powi(DIM as i32);
    let spacing = power(ball / DENSITY, 1.0 / DIM as Real);
    let filling = Filling {
        spacing,
        offset: spacing / 2.0 - RADIUS,
        margin: 0.0,
        speed: 5.0,
        ball: ColliderBuilder::ball(RADIUS),
    };
    filling.build(bodies, random)
}

pub(super) fn build_ghosts(bodies: usize, random: &mut Random) -> Stage {
    // Much less than their diameter.
    let spacing = 0.6;
    let filling = Filling {
        spacing,
        offset: 0.05,
        margin: RADIUS - spacing / 2.0 + 0.1,
        speed: 0.5,
        ball: ColliderBuilder::ball(RADIUS).collision_groups(GHOSTS),
    };
    filling.build(bodies, random)
}

impl Filling {
    fn build(self, bodies: usize, random: &mut Random) -> Stage {
        let lattice = Lattice::heap(bodies, self.spacing, 1.0);
        let container = Container::standing(
            lattice.half_width() + self.margin,
            lattice.height() + 2.0 * self.margin,
        );
        let elastic = |collider: ColliderBuilder| collider.restitution(1.0).friction(0.0).build();
        let mut world = floating();
        container.wall_in(&mut world, true, elastic);
        for index in 0..bodies {
            let mut center = lattice.center(index) + jitter(random, self.offset);
            center[UP] += self.margin;
            let ball = RigidBodyBuilder::dynamic()
                .translation(center)
                .linvel(jitter(random, self.speed))
                .can_sleep(false);
            world.insert(ball, elastic(self.ball.clone()));
        }
        Stage::new(world, container)
    }
}
