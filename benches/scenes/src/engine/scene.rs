//! A world with the script that drives it.

use super::container::Container;
use super::rapier::parry::partitioning::Bvh;
use super::rapier::prelude::*;
use super::scenes;
use super::script::{Cue, Script};
use super::space::UP;
use super::stage::{Link, Stage};
use super::version::AnyBroadPhase;
use super::world::World;
use crate::SceneKind;
use crate::random::Random;

/// A world with the script that drives it: what is moved, inserted or removed before each step.
///
/// Two scenes that were built alike stay alike, bit for bit, as long as the engine does: the script draws
/// from its own generator and depends on nothing else but the world. Rapier's default broad phase reports
/// the ends of pairs in an order that differs from one instance to the next, and the solver's result
/// depends on that order in its last bits.
pub struct Scene {
    /// The Rapier world.
    pub world: World,
    pub(super) containers: Vec<Container>,
    pub(super) links: Vec<Link>,
    pub(super) may_fall_through: usize,
    pub(super) cue: Cue,
    script: Box<dyn Script>,
    kind: SceneKind,
}

impl Clone for Scene {
    fn clone(&self) -> Self {
        Self {
            world: self.world.clone(),
            containers: self.containers.clone(),
            links: self.links.clone(),
            may_fall_through: self.may_fall_through,
            cue: self.cue.clone(),
            script: self.script.copy(),
            kind: self.kind,
        }
    }
}

impl Scene {
    /// Builds a scene of about this many bodies.
    ///
    /// Fixed floors, walls and obstacles come on top. Some scenes insert their bodies over time.
    pub fn build(kind: SceneKind, bodies: usize, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let Stage {
            world,
            script,
            containers,
            links,
            may_fall_through,
        } = scenes::build(kind, bodies, &mut random);
        let ground = containers[0].lo[UP];
        Self {
            world,
            cue: Cue {
                step: 0,
                random,
                supplied: 0.0,
                ground: if ground.is_finite() { ground } else { 0.0 },
            },
            containers,
            links,
            may_fall_through,
            script,
            kind,
        }
    }

    /// Which scene this is.
    pub fn kind(&self) -> SceneKind {
        self.kind
    }

    /// Runs the script for one step, with the tree of a broad phase for its questions, of which there may be none.
    /// [`World::step`] has to follow.
    pub fn prepare_asking<'t>(&mut self, tree: impl FnOnce() -> &'t Bvh) {
        let tree = self.script.asks().then(tree);
        self.run_script(tree);
    }

    fn run_script(&mut self, tree: Option<&Bvh>) {
        self.script.prepare(&mut self.world, &mut self.cue);
        if let Some(tree) = tree {
            self.script.ask(&mut self.world, &mut self.cue, tree);
        }
        self.cue.step += 1;
    }

    /// The rays that the scene wants cast after each step, whose answers change nothing.
    pub fn rays(&self) -> Vec<Ray> {
        self.script.rays(&self.world)
    }

    /// Runs the script, then advances the world by one time step.
    ///
    /// A script with questions gets a tree of its own, so that its answers do not depend on the broad phase.
    pub fn step(
        &mut self,
        broad_phase: &mut AnyBroadPhase,
        hooks: &dyn PhysicsHooks,
        events: &dyn EventHandler,
    ) {
        let tree = self.script.asks().then(|| self.world.tree());
        self.run_script(tree.as_ref());
        self.world.step(broad_phase, hooks, events);
    }
}
