//! Bullets: balls that are shot at a thin wall at very different speeds, without gravity.

use super::{
    Case, ColliderBuilder, DIM, Jitter, RigidBodyBuilder, Stage, World, along, cuboid, gauge,
    place, plus, vector,
};
use crate::accuracy::scene::Scene;

/// The radius of a bullet.
const RADIUS: f64 = 0.15;

/// The distance of two bullets across their way.
const SPACING: f64 = 0.6;

/// Half the thickness of the wall.
const HALF_WALL: f64 = 0.05;

/// How far the bullets fly before they hit.
const RANGE: f64 = 6.0;

/// How far a bullet may be off its place: along its way a step is as long as that, or longer.
const JITTER: f64 = 0.2;

/// The lowest and the highest speed, in units a second.
const SPEEDS: [f64; 2] = [10.0, 160.0];

/// The distance ahead at which soft CCD looks for the wall: that of the longest step.
const SOFT_DISTANCE: f64 = 6.0;

pub(super) fn build(case: &Case, jitter: &mut Jitter) -> Stage {
    let columns = match DIM {
        2 => 1,
        _ => (case.bodies as f64).sqrt().ceil() as usize,
    };
    let rows = case.bodies.div_ceil(columns);
    let mut world = World::new(vector(place(|_| 0.0)));
    let half_wide = rows.max(columns) as f64 * SPACING;
    let wall = cuboid(place(|axis| if axis == 0 { HALF_WALL } else { half_wide }));
    world.colliders.insert(wall);
    for index in 0..case.bodies {
        // Neighbours differ in speed: it is spread by the golden ratio.
        let share = (index as f64 * 0.618_034).fract();
        let speed = SPEEDS[0] * (SPEEDS[1] / SPEEDS[0]).powf(share);
        let cell = |count: usize, of: usize| (count as f64 - (of - 1) as f64 / 2.0) * SPACING;
        let from = place(|axis| match axis {
            0 => -RANGE,
            1 => cell(index / columns, rows),
            _ => cell(index % columns, columns),
        });
        let shift = along(0, jitter.by(JITTER));
        let bullet = RigidBodyBuilder::dynamic()
            .translation(vector(plus(from, shift)))
            .linvel(vector(along(0, speed)));
        let bullet = match case.scene {
            Scene::BulletsSoftCcd => bullet.soft_ccd_prediction(SOFT_DISTANCE as _),
            Scene::BulletsCcd => bullet.ccd_enabled(true),
            _ => bullet,
        };
        world.insert(bullet, ColliderBuilder::ball(RADIUS as _).density(5.0));
    }
    let energy = gauge::energy_gained(&world);
    Stage::new(world)
        .with(gauge::outside("impacts missed, of all", |place| {
            place[0] > 0.0
        }))
        .with(energy)
}
