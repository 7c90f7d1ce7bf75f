//! What happens in a scene besides physics: a script inserts, removes and steers bodies before each step.

use super::rapier::parry::partitioning::Bvh;
use super::rapier::prelude::*;
use super::space::{GRAVITY, UP, Vector, length, length_squared, own};
use super::world::World;
use crate::random::Random;

/// What is done to a world before each step.
pub(super) trait Script: Send {
    /// Prepares the world for the step of this cue.
    fn prepare(&mut self, _world: &mut World, _cue: &mut Cue) {}

    /// Whether it [asks](Self::ask): a tree has to be built for it where the broad phase cannot be asked.
    fn asks(&self) -> bool {
        false
    }

    /// Asks about the world as the last step left it, and acts on the answers. Follows `prepare`.
    fn ask(&mut self, _world: &mut World, _cue: &mut Cue, _tree: &Bvh) {}

    /// The rays to cast after a step. Nothing in the world depends on the answers.
    fn rays(&self, _world: &World) -> Vec<Ray> {
        Vec::new()
    }

    /// A script that goes on in the same way, in a clone of the world.
    fn copy(&self) -> Box<dyn Script>;
}

/// A script without questions.
impl<F: FnMut(&mut World, &mut Cue) + Clone + Send + 'static> Script for F {
    fn prepare(&mut self, world: &mut World, cue: &mut Cue) {
        self(world, cue);
    }

    fn copy(&self) -> Box<dyn Script> {
        Box::new(self.clone())
    }
}

/// What a script works with, and a record of the energy that it adds to the world.
#[derive(Clone)]
pub(super) struct Cue {
    /// How many steps were done before.
    pub(super) step: usize,
    /// The generator of the scene.
    pub(super) random: Random,
    /// The energy that was brought in so far. What was taken out is not subtracted.
    pub(super) supplied: f64,
    /// The height from which potential energy is counted.
    pub(super) ground: Real,
}

impl Cue {
    /// Inserts a body with one collider.
    pub(super) fn insert(
        &mut self,
        world: &mut World,
        body: impl Into<RigidBody>,
        collider: impl Into<Collider>,
    ) -> RigidBodyHandle {
        let (body, collider) = (body.into(), collider.into());
        let height = body.translation()[UP] - self.ground;
        let potential = length(world.gravity) * height.max(0.0);
        self.supply(
            collider.mass(),
            length_squared(own(body.linvel())) / 2.0 + potential,
        );
        world.insert(body, collider)
    }

    /// Gives a body a velocity.
    pub(super) fn push(&mut self, world: &mut World, handle: RigidBodyHandle, velocity: Vector) {
        let body = &mut world.bodies[handle];
        let gain = (length_squared(velocity) - length_squared(own(body.linvel()))) / 2.0;
        self.supply(body.mass(), gain.max(0.0));
        body.set_linvel(velocity, true);
    }

    /// Moves a body elsewhere, with another velocity.
    pub(super) fn throw(
        &mut self,
        world: &mut World,
        handle: RigidBodyHandle,
        from: Vector,
        velocity: Vector,
    ) {
        let lift = from[UP] - world.bodies[handle].translation()[UP];
        let mass = world.bodies[handle].mass();
        self.supply(mass, GRAVITY * lift.max(0.0));
        world.bodies[handle].set_translation(from, true);
        self.push(world, handle, velocity);
    }

    /// Notes that a body of this mass gained an energy per mass.
    pub(super) fn supply(&mut self, mass: Real, specific: Real) {
        self.supplied += f64::from(mass) * f64::from(specific);
    }
}
