//! The stages: worlds at their start, with what measures the errors in them. Each scene is in its own file.

use super::flavour::{INERTIA_OF_BALL, PIN};
use super::gauge::{self, Gauge};
use super::scenes::rapier::{math::DIM, prelude::*};
use super::scenes::{Scene as Ready, World};
use super::space::{GRAVITY, Place, UP, along, horizontal, place, plus, vector};
use crate::accuracy::case::Case;
use crate::accuracy::scene::Scene;
use oorandom::Rand32;

mod bullets;
mod hopper;
mod pendulum;
mod pile;
mod ropes;
mod silo;
mod stack;

/// A world at its start, and what measures the errors in it.
pub(super) struct Stage {
    pub(super) world: World,
    pub(super) gauges: Vec<Gauge>,
}

impl Stage {
    /// The stage of a case.
    pub(super) fn build(case: &Case) -> Self {
        let mut jitter = Jitter(Rand32::new(case.seed));
        match case.scene {
            Scene::Ropes => ropes::build(case),
            Scene::Pile => pile::build(case, &mut jitter),
            Scene::Hopper => hopper::build(case, &mut jitter),
            Scene::Stack => stack::build(case, &mut jitter),
            Scene::Bullets | Scene::BulletsSoftCcd | Scene::BulletsCcd => {
                bullets::build(case, &mut jitter)
            }
            Scene::Pendulum => pendulum::build(case, &mut jitter),
            Scene::Silo => silo::build(case, &mut jitter),
        }
    }

    fn new(world: World) -> Self {
        Self {
            world,
            gauges: Vec::new(),
        }
    }

    /// The same stage with another gauge.
    fn with(mut self, gauge: Gauge) -> Self {
        self.gauges.push(gauge);
        self
    }
}

/// The small differences between the starts of two seeds.
struct Jitter(Rand32);

impl Jitter {
    /// A number in `-amount..amount`.
    fn by(&mut self, amount: f64) -> f64 {
        (2.0 * f64::from(self.0.rand_float()) - 1.0) * amount
    }

    /// The same for each coordinate.
    fn place(&mut self, amount: f64) -> Place {
        place(|_| self.by(amount))
    }
}

/// A world with gravity and nothing else.
fn falling() -> World {
    World::new(vector(along(UP, -GRAVITY)))
}

/// A cuboid, from its half extents.
fn cuboid(half: Place) -> ColliderBuilder {
    let half = vector(half);
    ColliderBuilder::new(SharedShape::new(
        super::scenes::rapier::parry::shape::Cuboid::new(half),
    ))
}

/// Inserts a dynamic body with one collider.
fn insert(world: &mut World, at: Place, collider: ColliderBuilder) -> RigidBodyHandle {
    let body = RigidBodyBuilder::dynamic().translation(vector(at));
    world.insert(body, collider)
}

/// Half the thickness of floors and walls.
const HALF_WALL: f64 = 1.0;

/// Inserts a floor at height zero, as wide as this, and walls on all sides of it.
fn insert_room(
    world: &mut World,
    half_width: f64,
    height: f64,
    cover: impl Fn(ColliderBuilder) -> ColliderBuilder,
) -> ColliderHandle {
    for axis in horizontal() {
        for side in [-1.0, 1.0] {
            let half = place(|other| match other {
                UP => height / 2.0 + HALF_WALL,
                other if other == axis => HALF_WALL,
                _ => half_width + 2.0 * HALF_WALL,
            });
            let center = plus(
                along(axis, side * (half_width + HALF_WALL)),
                along(UP, height / 2.0 - HALF_WALL),
            );
            let wall = cuboid(half).translation(vector(center));
            world.colliders.insert(cover(wall));
        }
    }
    insert_floor(world, half_width, cover)
}

/// Inserts a floor at height zero, as wide as this.
fn insert_floor(
    world: &mut World,
    half_width: f64,
    cover: impl Fn(ColliderBuilder) -> ColliderBuilder,
) -> ColliderHandle {
    let half = place(|axis| match axis {
        UP => HALF_WALL,
        _ => half_width,
    });
    let floor = cuboid(half).translation(vector(along(UP, -HALF_WALL)));
    world.colliders.insert(cover(floor))
}

/// The centers of so many cells in layers from height zero up, with this many columns along each horizontal axis.
fn cells(count: usize, columns: usize, spacing: f64) -> impl Iterator<Item = Place> {
    let layer = columns.pow(DIM as u32 - 1);
    (0..count).map(move |index| {
        let mut rest = index % layer;
        place(|axis| {
            if axis == UP {
                return ((index / layer) as f64 + 0.5) * spacing;
            }
            let column = rest % columns;
            rest /= columns;
            (column as f64 - (columns - 1) as f64 / 2.0) * spacing
        })
    })
}

/// The number of columns with which a heap is about as high as it is wide.
fn columns(count: usize) -> usize {
    let exact = (count.max(1) as f64).powf(1.0 / DIM as f64);
    exact.round().max(1.0) as usize
}
