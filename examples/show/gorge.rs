//! A stampede: animals run through a gorge with rocks in it, avoid each other, and start again at its beginning.

use super::scenes::World;
use super::scenes::rapier::prelude::*;
use super::show::{HeldPairs, Show};
use unisize_pictures::{Camera, Color, Drawing, palette};

/// Half the length and half the width of an animal.
const HALF_LENGTH: Real = 0.32;
const HALF_WIDTH: Real = 0.14;

/// How far an animal sees; the side of its box.
const SIGHT: Real = 1.1;

/// Animals nearer than this avoid each other more strongly.
const PERSONAL: Real = 0.55;

/// The preferred and the highest speed of animals, in units of length per second.
const SPEED: Real = 5.0;
const FASTEST: Real = 8.0;

/// How strongly animals keep to their way, avoid each other, align with each other, and avoid rocks.
const EAGERNESS: Real = 2.5;
const AVERSION: Real = 22.0;
const ALIGNMENT: Real = 1.2;
const CAUTION: Real = 40.0;

/// The area per animal at the start.
const ROOM: Real = 0.55;

/// The length of the gorge over its height.
const ASPECT: Real = 2.0;

/// The animals, and the rocks between which they run.
pub(crate) struct Gorge {
    world: World,
    animals: Vec<Animal>,
    rocks: Vec<Rock>,
    /// Half the height of the gorge. It is [`ASPECT`] times as long.
    half_height: Real,
}

struct Animal {
    body: RigidBodyHandle,
    place: Vector<Real>,
    velocity: Vector<Real>,
    wish: Vector<Real>,
}

struct Rock {
    center: Vector<Real>,
    radius: Real,
}

/// The owner of a collider, kept in its user data.
enum Owner {
    Animal(usize),
    Rock(usize),
}

impl Owner {
    fn of(collider: &Collider) -> Self {
        let index = (collider.user_data >> 1) as usize;
        match collider.user_data & 1 {
            0 => Self::Animal(index),
            _ => Self::Rock(index),
        }
    }

    fn user_data(&self) -> u128 {
        match *self {
            Self::Animal(index) => (index as u128) << 1,
            Self::Rock(index) => (index as u128) << 1 | 1,
        }
    }
}

impl Gorge {
    fn half_length(&self) -> Real {
        ASPECT * self.half_height
    }

    /// Half the distance between the cliffs, which is narrow in the middle.
    fn half_way(half_height: Real, x: Real) -> Real {
        let share = x / (ASPECT * half_height);
        half_height * (0.86 - 0.42 * (-10.0 * share * share).exp())
    }

    fn insert_rock(&mut self, center: Vector<Real>, radius: Real) {
        let owner = Owner::Rock(self.rocks.len());
        let ball = ColliderBuilder::ball(radius).translation(center);
        self.world
            .colliders
            .insert(ball.user_data(owner.user_data()));
        self.rocks.push(Rock { center, radius });
    }

    /// Cliffs on both sides, and some rocks in the way.
    fn insert_rocks(&mut self, random: &mut oorandom::Rand32) {
        let unit = self.half_height / 12.0;
        let mut x = -self.half_length() - 4.0 * unit;
        while x < self.half_length() + 4.0 * unit {
            for side in [-1.0, 1.0] {
                let radius = (1.6 + 0.9 * random.rand_float()) * unit;
                let way = Self::half_way(self.half_height, x) + radius;
                self.insert_rock(vector![x, side * way], radius);
            }
            x += 1.5 * unit;
        }
        for (x, y, radius) in [
            (-11.0, 2.6, 1.3),
            (-6.5, -3.4, 1.0),
            (9.5, -1.2, 1.5),
            (15.0, 4.6, 1.0),
        ] {
            self.insert_rock(vector![x, y] * unit, radius * unit);
        }
    }

    fn is_free(&self, place: &Vector<Real>) -> bool {
        let is_clear = |rock: &Rock| (place - rock.center).norm() > rock.radius + HALF_LENGTH;
        place.y.abs() < Self::half_way(self.half_height, place.x) && self.rocks.iter().all(is_clear)
    }

    fn insert_animals(&mut self, count: usize, random: &mut oorandom::Rand32) {
        while self.animals.len() < count {
            let mut within = |half: Real| (2.0 * random.rand_float() - 1.0) * half;
            let place = vector![within(self.half_length()), within(self.half_height)];
            if !self.is_free(&place) {
                continue;
            }
            let owner = Owner::Animal(self.animals.len());
            let animal = RigidBodyBuilder::kinematic_velocity_based().translation(place);
            let sight = ColliderBuilder::cuboid(SIGHT / 2.0, SIGHT / 2.0).sensor(true);
            let body = self
                .world
                .insert(animal, sight.user_data(owner.user_data()));
            self.animals.push(Animal {
                body,
                place,
                velocity: vector![SPEED, within(0.5)],
                wish: Vector::zeros(),
            });
        }
    }

    /// Two animals that see each other keep apart and align.
    fn meet(&mut self, first: usize, second: usize) {
        let way = self.animals[second].place - self.animals[first].place;
        let distance = way.norm();
        if distance >= SIGHT {
            return;
        }
        let apart = way / distance.max(1e-3);
        let nearness = 1.0 - distance / SIGHT;
        let urgency = if distance < PERSONAL { 3.0 } else { 1.0 };
        let push = apart * (AVERSION * nearness * nearness * urgency);
        let likeness =
            (self.animals[second].velocity - self.animals[first].velocity) * (ALIGNMENT * nearness);
        self.animals[first].wish += likeness - push;
        self.animals[second].wish += push - likeness;
    }

    /// An animal that sees a rock goes around it on its own side.
    fn avoid(&mut self, animal: usize, rock: usize) {
        let rock = &self.rocks[rock];
        let animal = &mut self.animals[animal];
        let way = animal.place - rock.center;
        let distance = way.norm().max(1e-3);
        let nearness = (1.0 - (distance - rock.radius) / SIGHT).clamp(0.0, 2.0);
        let away = way / distance;
        let mut around = vector![-away.y, away.x];
        if around.x < 0.0 {
            around = -around;
        }
        animal.wish += (away + around * 0.5) * (CAUTION * nearness * nearness);
    }

    /// Turns wishes into velocities, and moves animals that have left the gorge back to its beginning.
    fn run(&mut self) {
        let dt = self.world.params.dt;
        let half_length = self.half_length();
        for animal in &mut self.animals {
            let wanted = vector![SPEED, -0.12 * animal.place.y];
            let wish = animal.wish + (wanted - animal.velocity) * EAGERNESS;
            animal.velocity += wish * dt;
            let speed = animal.velocity.norm();
            animal.velocity *= (FASTEST / speed.max(1e-3)).min(1.0);
            let body = &mut self.world.bodies[animal.body];
            if animal.place.x > half_length {
                animal.place.x -= 2.0 * half_length;
                body.set_translation(animal.place, true);
            }
            body.set_linvel(animal.velocity, true);
        }
    }
}

impl Show for Gorge {
    const NAME: &'static str = "crowd2d";
    const ABOUT: &'static str =
        "A stampede through a gorge: the pairs of boxes are the neighbours that animals avoid";
    const BODIES: usize = 800;
    const STEPS: usize = 300;
    const STEPS_PER_FRAME: usize = 3;
    const FILMED_FROM: usize = 120;
    const COLORS: usize = 64;
    const TOLERANCE: u8 = 18;

    fn build(bodies: usize) -> Self {
        let half_height = (bodies as Real * ROOM / (4.0 * ASPECT * 0.65))
            .sqrt()
            .max(4.0);
        let mut show = Self {
            world: World::new(Vector::zeros()),
            animals: Vec::new(),
            rocks: Vec::new(),
            half_height,
        };
        let mut random = oorandom::Rand32::new(3);
        show.insert_rocks(&mut random);
        show.insert_animals(bodies, &mut random);
        show
    }

    fn world(&mut self) -> &mut World {
        &mut self.world
    }

    fn prepare(&mut self, _: usize, broad_phase: &dyn HeldPairs) {
        for animal in &mut self.animals {
            animal.place = *self.world.bodies[animal.body].translation();
            animal.wish = Vector::zeros();
        }
        for pair in broad_phase.pairs() {
            let owner = |handle| Owner::of(&self.world.colliders[handle]);
            match (owner(pair.collider1), owner(pair.collider2)) {
                (Owner::Animal(first), Owner::Animal(second)) => self.meet(first, second),
                (Owner::Animal(animal), Owner::Rock(rock))
                | (Owner::Rock(rock), Owner::Animal(animal)) => self.avoid(animal, rock),
                (Owner::Rock(_), Owner::Rock(_)) => {}
            }
        }
        self.run();
    }

    fn bodies(&self) -> usize {
        self.animals.len()
    }

    fn camera(&self) -> Camera {
        Camera::top_down([0.0; 2], 1.96 * self.half_height)
    }

    fn draw(&self, drawing: &mut Drawing, _: &dyn HeldPairs) {
        drawing.background(Color([0x4a, 0x56, 0x68]), Color([0x4a, 0x56, 0x68]));
        for animal in &self.animals {
            let (forward, half) = (animal.velocity, [HALF_LENGTH, HALF_WIDTH]);
            let angle = forward.y.atan2(forward.x);
            let color = palette::by_share((forward.norm() - 2.0) / (FASTEST - 2.0));
            let place = *self.world.bodies[animal.body].translation();
            drawing.rectangle(place.into(), half, angle, color);
            let head = place + forward * (HALF_LENGTH / forward.norm().max(1e-3));
            drawing.disc(head.into(), HALF_WIDTH, color);
        }
        for rock in &self.rocks {
            drawing.disc(rock.center.into(), rock.radius, palette::HORIZON);
        }
        for rock in &self.rocks {
            drawing.disc(rock.center.into(), 0.9 * rock.radius, palette::SKY);
        }
    }
}
