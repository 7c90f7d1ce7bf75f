//! Builds the worlds of the cases.

use super::scenes::rapier::{math::DIM, prelude::*};
use super::scenes::{Point, Vector, World, spin};
use super::space::{GRAVITY, Place, UP, along, place, vector};
use super::stage::Stage;
use crate::stability::case::{Case, Setup};
use oorandom::Rand32;
use std::f64::consts::{FRAC_PI_2, TAU};

/// The largest distance from its place at which a body starts, on each horizontal axis, in metres. The seeds differ in it.
const JITTER: f64 = 0.02;

/// Links of a chain.
const LINKS: usize = 100;

/// Of a link: the distance between its two joints, and the radius, in metres.
const LINK: f64 = 0.5;
const LINK_RADIUS: f64 = 0.1;

/// Balls that are shot: their number, radius, and distance from each other and from the wall, in metres.
const SHOTS: usize = 5;
const SHOT_RADIUS: f64 = 0.25;
const SHOT_APART: f64 = 1.5;
const SHOT_FROM: f64 = 2.0;

/// The thickness of the wall that they are shot at, in metres.
const WALL: f64 = 0.1;

/// Half the width of the box of spinning boxes, in metres, and the thickness of its sides.
const HALF_WIDTH: f64 = 3.0;
const SIDE: f64 = 1.0;

impl Stage {
    /// Builds the world of a case with the start of this seed.
    pub(super) fn build(case: &Case, seed: u64) -> Self {
        let mut builder = Builder::new(case, seed);
        match case.setup {
            Setup::Stack(boxes) => builder.stack(boxes, |_| 1.0),
            Setup::Press { ratio } => {
                builder.stack(4, |layer| if layer == 3 { ratio } else { 1.0 })
            }
            Setup::Chain { ratio } => builder.chain(ratio),
            Setup::Spin { speed } => builder.spinning(speed),
            Setup::Shots { speed, has_ccd } => builder.shots(speed, has_ccd),
            Setup::Burst { speed } => builder.burst(speed),
        }
        builder.stage
    }
}

/// A stage in the making. All arguments are in metres.
struct Builder<'a> {
    case: &'a Case,
    random: Rand32,
    stage: Stage,
}

impl<'a> Builder<'a> {
    fn new(case: &'a Case, seed: u64) -> Self {
        let mut world = World::new(vector(along(UP, -GRAVITY * case.metre)));
        world.params.dt = case.dt as Real;
        world.params.length_unit = case.length_unit as Real;
        let stage = Stage {
            world,
            places: Vec::new(),
            links: Vec::new(),
            bounds: [[f64::NEG_INFINITY; DIM], [f64::INFINITY; DIM]],
            is_lawless: false,
            metre: case.metre,
            link: LINK * case.metre,
        };
        Self {
            case,
            random: Rand32::new(seed),
            stage,
        }
    }

    /// A length in units.
    fn length(&self, metres: f64) -> Real {
        (metres * self.case.metre) as Real
    }

    /// A coordinate in units.
    fn coordinate(&self, metres: f64) -> f64 {
        metres * self.case.metre + self.case.offset
    }

    /// A displacement or a velocity.
    fn vector(&self, metres: Place) -> Vector {
        vector(metres.map(|x| x * self.case.metre))
    }

    /// A place.
    fn place(&self, metres: Place) -> Vector {
        vector(metres.map(|x| self.coordinate(x)))
    }

    fn range(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * f64::from(self.random.rand_float())
    }

    /// A place near this one on the same height.
    fn near(&mut self, mut place: Place) -> Place {
        for axis in (0..DIM).filter(|&axis| axis != UP) {
            place[axis] += self.range(-JITTER, JITTER);
        }
        place
    }

    fn cuboid(&self, half: Place) -> ColliderBuilder {
        ColliderBuilder::new(SharedShape::new(Cuboid::new(self.vector(half))))
    }

    fn insert_fixed(&mut self, center: Place, half: Place) {
        let collider = self.cuboid(half).translation(self.place(center));
        self.stage.world.colliders.insert(collider);
    }

    /// Boxes on top of each other, with a mass for each layer, on a floor whose surface is at height zero.
    fn stack(&mut self, boxes: usize, mass: impl Fn(usize) -> f64) {
        let floor = place(|axis| if axis == UP { 0.5 } else { 50.0 });
        self.insert_fixed(along(UP, -0.5), floor);
        for layer in 0..boxes {
            let center = self.near(along(UP, layer as f64 + 0.5));
            let collider = self.cuboid([0.5; DIM]).mass(mass(layer) as Real);
            let body = RigidBodyBuilder::dynamic().translation(self.place(center));
            let body = self.stage.world.insert(body, collider);
            let place = center.map(|x| self.coordinate(x));
            self.stage.places.push((body, place));
        }
    }

    /// A chain that starts along the first axis. Each link has a small velocity of its own.
    fn chain(&mut self, ratio: f64) {
        let hook = RigidBodyBuilder::fixed().translation(self.place([0.0; DIM]));
        let mut last = self.stage.world.bodies.insert(hook);
        let mut anchor = self.vector([0.0; DIM]);
        for link in 0..LINKS {
            let center = along(0, (link as f64 + 0.5) * LINK);
            let velocity = place(|_| self.range(-0.5, 0.5));
            let body = RigidBodyBuilder::dynamic()
                .translation(self.place(center))
                .rotation(spin([0.0, 0.0, FRAC_PI_2 as Real]))
                .linvel(self.vector(velocity));
            let [half, radius] = [LINK / 2.0, LINK_RADIUS].map(|x| self.length(x));
            let capsule = ColliderBuilder::capsule_y(half, radius).mass(1.0);
            let body = self.stage.world.insert(body, capsule);
            // Lying turns the upper end of a capsule to the negative side of the first axis.
            let upper = vector(along(UP, half.into()));
            self.join(last, anchor, body, upper);
            (last, anchor) = (body, -upper);
        }
        let radius = self.length(LINK / 2.0);
        let center = along(0, (LINKS as f64 + 0.5) * LINK);
        let body = RigidBodyBuilder::dynamic().translation(self.place(center));
        let ball = ColliderBuilder::ball(radius).mass(ratio as Real);
        let body = self.stage.world.insert(body, ball);
        self.join(last, anchor, body, vector(along(0, -f64::from(radius))));
    }

    fn join(&mut self, a: RigidBodyHandle, on_a: Vector, b: RigidBodyHandle, on_b: Vector) {
        let pin = GenericJointBuilder::new(JointAxesMask::LIN_AXES)
            .local_anchor1(Point::from(on_a))
            .local_anchor2(Point::from(on_b))
            .contacts_enabled(false);
        let joint = self.stage.world.impulse_joints.insert(a, b, pin, true);
        self.stage.links.push((joint, [a, b]));
    }

    /// Eight boxes in a closed box.
    fn spinning(&mut self, speed: f64) {
        let center = |axis: usize| if axis == UP { HALF_WIDTH } else { 0.0 };
        for axis in 0..DIM {
            for side in [-1.0, 1.0] {
                let mut place: Place = std::array::from_fn(center);
                place[axis] += side * (HALF_WIDTH + SIDE / 2.0);
                let mut half = [HALF_WIDTH + SIDE; DIM];
                half[axis] = SIDE / 2.0;
                self.insert_fixed(place, half);
            }
        }
        // Outside by more than a box.
        self.stage.bounds = [-1.0, 1.0].map(|side: f64| {
            std::array::from_fn(|axis| self.coordinate(center(axis) + side * (HALF_WIDTH + 1.0)))
        });
        for index in 0..8 {
            let cells = match DIM {
                2 => [index % 2, index / 2, 0],
                _ => [index % 2, index / 4, index / 2 % 2],
            };
            let place = std::array::from_fn(|axis| match axis {
                UP => 0.75 + 1.5 * cells[axis] as f64,
                _ => 1.5 * (cells[axis] as f64 - 0.5),
            });
            let place = self.near(place);
            self.fly(place, [0.0; DIM], speed, false);
        }
    }

    /// Inserts a box that flies and spins.
    fn fly(&mut self, center: Place, velocity: Place, speed_of_spin: f64, has_ccd: bool) {
        // Any axis, the same for all flavours; in 2D there is only the third one.
        let [a, b] = [0, 1].map(|_| self.range(0.0, TAU));
        let axis = match DIM {
            2 => [0.0, 0.0, 1.0],
            _ => [a.cos() * b.cos(), a.sin() * b.cos(), b.sin()],
        };
        let body = RigidBodyBuilder::dynamic()
            .translation(self.place(center))
            .linvel(self.vector(velocity))
            .angvel(spin(axis.map(|x| speed_of_spin as Real * x as Real)))
            .ccd_enabled(has_ccd);
        let collider = self.cuboid([0.5; DIM]);
        self.stage.world.insert(body, collider);
    }

    /// Balls that fly at a wall without gravity.
    fn shots(&mut self, speed: f64, has_ccd: bool) {
        self.stage.world.gravity = Vector::default();
        let mut half = [SHOTS as f64 * SHOT_APART; DIM];
        half[0] = WALL / 2.0;
        self.insert_fixed(along(0, WALL / 2.0), half);
        self.stage.bounds[1][0] = self.coordinate(WALL + 2.0 * SHOT_RADIUS);
        for index in 0..SHOTS {
            let mut place = [0.0; DIM];
            place[0] = -SHOT_FROM - self.range(0.0, 1.0);
            place[UP] = (index as f64 - (SHOTS - 1) as f64 / 2.0) * SHOT_APART;
            let body = RigidBodyBuilder::dynamic()
                .translation(self.place(place))
                .linvel(self.vector(along(0, speed)))
                .ccd_enabled(has_ccd);
            let ball = ColliderBuilder::ball(self.length(SHOT_RADIUS));
            self.stage.world.insert(body, ball);
        }
    }

    /// A stack, and boxes next to it that fly to all sides. Those without CCD spin as well: with CCD, Rapier's search for the time of impact
    /// of a fast spin does not end on any broad phase.
    fn burst(&mut self, speed: f64) {
        self.stage.is_lawless = true;
        self.stack(5, |_| 1.0);
        for (index, has_ccd) in [false, true, false, true].into_iter().enumerate() {
            let mut place = along(UP, 0.75 + 1.5 * (index % 2) as f64);
            place[0] = if index < 2 { -5.0 } else { 5.0 };
            let place = self.near(place);
            let velocity = match index {
                0 | 1 => along(0, speed),
                2 => along(UP, -speed),
                _ => [0.0; DIM],
            };
            let spin = if has_ccd { 0.0 } else { speed };
            self.fly(place, velocity, spin, has_ccd);
        }
    }
}
