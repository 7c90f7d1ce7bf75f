//! A container with glass walls, filled by a jet of grains that circles above it.

use super::scenes::World;
use super::scenes::rapier::prelude::*;
use super::show::{HeldPairs, Show};
use std::f32::consts::TAU;
use unisize_pictures::{Camera, Color, Drawing, palette};

/// The radius of a grain.
const RADIUS: Real = 0.1;

/// The distance between the grains of a layer of the jet, and between layers.
const SPACING: Real = 2.2 * RADIUS;

/// The speed of the jet.
const SPEED: Real = 8.0;

/// The share of the steps by which all grains are poured.
const POURED: f32 = 0.8;

/// Steps in which the jet goes round once.
const ROUND: f32 = 120.0;

/// The grains change colour this many times.
const COLORS: usize = 6;

/// Half the thickness of walls and of the bars between them.
const HALF_WALL: Real = 0.5;
const HALF_BAR: Real = 0.05;

/// Grains that are poured into a container.
pub(crate) struct Pour {
    world: World,
    grains: Vec<ColliderHandle>,
    /// How many grains there will be.
    bodies: usize,
    /// Half the width of the container, and its height.
    half_width: Real,
    height: Real,
}

impl Pour {
    /// Inserts the floor and the walls, which reach far above the visible rim so that nothing is spilt.
    fn insert_container(&mut self) {
        let half = self.half_width;
        let out = half + HALF_WALL;
        let mut insert = |half_extents: Vector<Real>, center: Vector<Real>| {
            let wall = ColliderBuilder::cuboid(half_extents.x, half_extents.y, half_extents.z);
            self.world
                .colliders
                .insert(wall.translation(center).friction(0.3));
        };
        insert(
            vector![out + HALF_WALL, HALF_WALL, out + HALF_WALL],
            vector![0.0, -HALF_WALL, 0.0],
        );
        for side in [-1.0, 1.0] {
            let upper = 2.0 * self.height;
            insert(
                vector![HALF_WALL, upper, out + HALF_WALL],
                vector![side * out, upper, 0.0],
            );
            insert(
                vector![out + HALF_WALL, upper, HALF_WALL],
                vector![0.0, upper, side * out],
            );
        }
    }

    /// Inserts a layer of at most `count` grains into the jet.
    fn insert_layer(&mut self, step: usize, count: usize) {
        let angle = step as Real / ROUND * TAU;
        let middle = vector![angle.cos(), 0.0, angle.sin()] * (0.4 * self.half_width)
            + vector![0.0, 1.7 * self.height, 0.0];
        for index in 0..count {
            // The pattern of a sunflower's seeds keeps grains apart.
            let away = SPACING * 0.6 * (index as Real).sqrt();
            let (sine, cosine) = (index as Real * 2.399_963 + 0.1 * step as Real).sin_cos();
            let grain = RigidBodyBuilder::dynamic()
                .translation(middle + vector![cosine, 0.0, sine] * away)
                .linvel(vector![0.0, -SPEED, 0.0]);
            let ball = ColliderBuilder::ball(RADIUS).friction(0.3).restitution(0.1);
            let grain = self.world.insert(grain, ball);
            self.grains.push(self.world.bodies[grain].colliders()[0]);
        }
    }

    fn color(&self, grain: usize) -> Color {
        palette::by_index(grain * COLORS / self.bodies.max(1))
    }
}

impl Show for Pour {
    const NAME: &'static str = "particles3d";
    const ABOUT: &'static str = "Grains are poured into a container, colour after colour";
    const BODIES: usize = 20_000;
    const STEPS: usize = 560;
    const STEPS_PER_FRAME: usize = 7;
    const TOLERANCE: u8 = 11;

    fn build(bodies: usize) -> Self {
        // Half as high as wide, filled to nine tenths.
        let volume = bodies as Real * (2.0 * RADIUS).powi(3) * 0.9;
        let half_width = volume.cbrt().max(8.0 * RADIUS) * 0.63;
        let mut show = Self {
            world: World::new(vector![0.0, -9.81, 0.0]),
            grains: Vec::new(),
            bodies,
            half_width,
            height: half_width,
        };
        show.insert_container();
        show
    }

    fn world(&mut self) -> &mut World {
        &mut self.world
    }

    fn prepare(&mut self, step: usize, _: &dyn HeldPairs) {
        let share = step as f32 / (POURED * Self::STEPS as f32);
        let poured = (self.bodies as f32 * share.min(1.0)).ceil() as usize;
        let interval = (SPACING / SPEED * 60.0).ceil() as usize;
        if step % interval == 0 {
            self.insert_layer(step, poured.saturating_sub(self.grains.len()));
        }
    }

    fn bodies(&self) -> usize {
        self.grains.len()
    }

    fn camera(&self) -> Camera {
        Camera::orbit(
            [-0.32 * self.half_width, 0.55 * self.height, 0.0],
            4.7 * self.half_width,
        )
        .turned(0.6)
        .raised(0.42)
    }

    fn draw(&self, drawing: &mut Drawing, _: &dyn HeldPairs) {
        let upright = [0.0, 0.0, 0.0, 1.0];
        drawing.ground(-0.1);
        let edge = self.half_width + HALF_BAR;
        let (middle, half) = (self.height / 2.0, self.height / 2.0);
        drawing.cuboid(
            [0.0, -0.05, 0.0],
            [edge, 0.05, edge],
            upright,
            palette::FIXED,
        );
        for side in [-1.0, 1.0] {
            for other in [-1.0, 1.0] {
                let post = [side * edge, middle, other * edge];
                drawing.cuboid(post, [HALF_BAR, half, HALF_BAR], upright, palette::FIXED);
            }
            for (center, extents) in [
                (
                    [side * edge, self.height, 0.0],
                    [HALF_BAR, HALF_BAR, edge + HALF_BAR],
                ),
                (
                    [0.0, self.height, side * edge],
                    [edge + HALF_BAR, HALF_BAR, HALF_BAR],
                ),
            ] {
                drawing.cuboid(center, extents, upright, palette::FIXED);
            }
        }
        for (index, &grain) in self.grains.iter().enumerate() {
            let center = *self.world.colliders[grain].translation();
            drawing.sphere(center.into(), RADIUS, self.color(index));
        }
    }
}
