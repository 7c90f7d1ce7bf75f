//! Boxes of one size start evenly spread over a square, fly through its centre and through each other: first a cluster, then
//! a ring.

use super::scenes::World;
use super::scenes::rapier::prelude::*;
use super::show::{HeldPairs, Show};
use unisize_pictures::{Camera, Drawing, palette};
use unisize_scenes::ConvergingBoxes;

/// Half the side of a box.
const HALF: Real = 0.5;

/// A box with this many pairs has the last colour.
const MANY: f32 = 120.0;

/// The place of a box without pairs on the scale of colours, 0 to 1.
const ALONE: f32 = 0.28;

/// Boxes that fly through the centre of a square.
pub(crate) struct Implosion {
    world: World,
    boxes: Vec<ColliderHandle>,
    /// Half the side of the square.
    half_width: Real,
}

impl Show for Implosion {
    const NAME: &'static str = "cluster";
    const ABOUT: &'static str =
        "Boxes in a plane all fly through its centre, without contact response";
    const BODIES: usize = 100_000;
    const STEPS: usize = 2 * ConvergingBoxes::HALF_WAY;
    const STEPS_PER_FRAME: usize = 10;
    const COLORS: usize = 48;
    const TOLERANCE: u8 = 26;
    const CONTACTS: bool = false;

    fn build(bodies: usize) -> Self {
        let start = ConvergingBoxes::new(bodies, 5);
        let mut world = World::new(Vector::zeros());
        let frames_a_second = world.params.dt.recip();
        let boxes = start
            .mins()
            .iter()
            .zip(start.velocities())
            .map(|(mins, velocity)| {
                let [x, z] = mins.map(|x| x + HALF);
                let [vx, vz] = velocity.map(|v| v * frames_a_second);
                let body = RigidBodyBuilder::kinematic_velocity_based()
                    .translation(vector![x, 0.0, z])
                    .linvel(vector![vx, 0.0, vz]);
                let body = world.insert(body, ColliderBuilder::cuboid(HALF, HALF, HALF));
                world.bodies[body].colliders()[0]
            })
            .collect();
        Self {
            world,
            boxes,
            half_width: start.half_side(),
        }
    }

    fn world(&mut self) -> &mut World {
        &mut self.world
    }

    fn bodies(&self) -> usize {
        self.boxes.len()
    }

    fn camera(&self) -> Camera {
        let forward = 0.12 * self.half_width;
        Camera::orbit([0.5 * forward, 0.0, forward], 3.45 * self.half_width)
            .raised(0.85)
            .turned(0.5)
    }

    fn draw(&self, drawing: &mut Drawing, broad_phase: &dyn HeldPairs) {
        drawing.background(palette::HORIZON, palette::PANEL);
        let mut counts = vec![0_u32; self.world.colliders.len()];
        for pair in broad_phase.pairs() {
            for collider in [pair.collider1, pair.collider2] {
                counts[collider.into_raw_parts().0 as usize] += 1;
            }
        }
        for &handle in &self.boxes {
            let collider = &self.world.colliders[handle];
            let count = counts[handle.into_raw_parts().0 as usize] as f32;
            let share = (1.0 + count).ln() / MANY.ln();
            let color = palette::by_share(ALONE + (1.0 - ALONE) * share);
            let center: [f32; 3] = (*collider.translation()).into();
            drawing.cuboid(center, [HALF; 3], [0.0, 0.0, 0.0, 1.0], color);
        }
    }
}
