//! Layers of ropes, each across the one below and turning against it, fall over bars.

use super::scenes::World;
use super::scenes::rapier::prelude::*;
use super::show::{HeldPairs, Show};
use unisize_pictures::{Camera, Color, Drawing, palette};

/// Capsules per rope.
const SEGMENTS: usize = 40;

/// Half the distance between the joints of a capsule, and its radius.
const HALF: Real = 0.12;
const RADIUS: Real = 0.085;

/// The distance between the ropes of a layer, and between layers.
const SPACING: Real = 0.42;

/// The height of the lowest layer.
const HEIGHT: Real = 2.9;

/// How fast a layer turns at the start, in radians per second.
const SPIN: Real = 1.4;

/// Ropes that fall over bars.
pub(crate) struct Ropes {
    world: World,
    /// The capsules, rope after rope.
    segments: Vec<ColliderHandle>,
    bars: Vec<ColliderHandle>,
    /// Half the width of a layer.
    half_width: Real,
}

impl Ropes {
    fn insert_bars(&mut self) {
        let reach = self.half_width * 0.8;
        for side in [-1.0, 1.0] {
            let place = side * self.half_width * 0.42;
            for (from, to) in [
                (point![-reach, 1.3, place], point![reach, 1.3, place]),
                (point![place, 2.1, -reach], point![place, 2.1, reach]),
            ] {
                let bar = ColliderBuilder::capsule_from_endpoints(from, to, 0.16).friction(0.6);
                self.bars.push(self.world.colliders.insert(bar));
            }
        }
    }

    /// Inserts a rope along one axis of its layer, at this place on the other.
    fn insert_rope(&mut self, layer: usize, place: Real, segments: usize) {
        let length = 2.0 * HALF * SEGMENTS as Real;
        let lies_along_x = layer % 2 == 0;
        let spin = if layer % 4 < 2 { SPIN } else { -SPIN };
        let mut previous = None;
        for segment in 0..segments {
            let along = (2 * segment + 1) as Real * HALF - length / 2.0;
            // A wave, so that ropes are not quite straight.
            let height = HEIGHT + layer as Real * SPACING + 0.1 * (along * 1.7 + place * 3.1).sin();
            let center = if lies_along_x {
                vector![along, height, place]
            } else {
                vector![place, height, along]
            };
            let body = RigidBodyBuilder::dynamic()
                .translation(center)
                .linvel(vector![-center.z, 0.0, center.x] * spin)
                .angular_damping(1.0);
            let half = if lies_along_x {
                vector![HALF, 0.0, 0.0]
            } else {
                vector![0.0, 0.0, HALF]
            };
            let [start, end] = [Point::from(-half), Point::from(half)];
            let capsule = ColliderBuilder::capsule_from_endpoints(start, end, RADIUS).friction(0.5);
            let body = self.world.insert(body, capsule);
            self.segments.push(self.world.bodies[body].colliders()[0]);
            if let Some(before) = previous {
                let joint = SphericalJointBuilder::new()
                    .local_anchor1(end)
                    .local_anchor2(start)
                    .contacts_enabled(false);
                self.world.impulse_joints.insert(before, body, joint, true);
            }
            previous = Some(body);
        }
    }
}

impl Show for Ropes {
    const NAME: &'static str = "rope3d";
    const ABOUT: &'static str = "Ropes of jointed capsules fall over bars and tangle";
    const BODIES: usize = 2_000;
    const STEPS: usize = 260;
    const STEPS_PER_FRAME: usize = 4;
    const COLORS: usize = 160;
    const TOLERANCE: u8 = 8;

    fn build(bodies: usize) -> Self {
        let ropes = bodies.div_ceil(SEGMENTS);
        let width = ((ropes as Real).sqrt().ceil() as usize).max(1);
        let length = 2.0 * HALF * SEGMENTS as Real;
        let mut show = Self {
            world: World::new(vector![0.0, -9.81, 0.0]),
            segments: Vec::new(),
            bars: Vec::new(),
            half_width: (width as Real * SPACING).max(length) / 2.0,
        };
        let floor = ColliderBuilder::cuboid(50.0, 1.0, 50.0).translation(vector![0.0, -1.0, 0.0]);
        show.world.colliders.insert(floor);
        show.insert_bars();
        for rope in 0..ropes {
            let place = (rope % width) as Real - (width - 1) as Real / 2.0;
            let segments = SEGMENTS.min(bodies - rope * SEGMENTS);
            show.insert_rope(rope / width, place * SPACING, segments);
        }
        show
    }

    fn world(&mut self) -> &mut World {
        &mut self.world
    }

    fn bodies(&self) -> usize {
        self.segments.len()
    }

    fn camera(&self) -> Camera {
        Camera::orbit([-0.7, 1.9, 0.4], 1.5 * self.half_width + 6.0)
            .turned(0.55)
            .raised(0.38)
    }

    fn draw(&self, drawing: &mut Drawing, _: &dyn HeldPairs) {
        drawing.ground(0.0);
        for &bar in &self.bars {
            draw_capsule(drawing, &self.world.colliders[bar], palette::FIXED);
        }
        for (index, &segment) in self.segments.iter().enumerate() {
            let color = palette::by_index(index / SEGMENTS);
            draw_capsule(drawing, &self.world.colliders[segment], color);
        }
    }
}

fn draw_capsule(drawing: &mut Drawing, collider: &Collider, color: Color) {
    if let Some(capsule) = collider.shape().as_capsule() {
        let place = |point: Point<Real>| (collider.position() * point).coords.into();
        let ends = [capsule.segment.a, capsule.segment.b].map(place);
        drawing.capsule(ends, capsule.radius, color);
    }
}
