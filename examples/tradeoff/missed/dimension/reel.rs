//! The frames that all methods get: a scene that Rapier's own broad phase drives, step by step.

use super::scenes::rapier::prelude::*;
use super::scenes::{Observed, Scene};
use super::straight::Motions;
use super::{Stage, Truth};
use crate::options::Options;
use unisize_scenes::SceneKind;

/// A scene that is driven step by step.
pub(super) struct Reel {
    scene: Scene,
    driver: Observed<DefaultBroadPhase>,
    typical_size: Real,
    /// Whether no step has been shown yet.
    is_new: bool,
}

/// A step, for all methods.
pub(super) struct Frame {
    pub(super) stage: Stage,
    /// The same with everything at the beginning of the step and with the velocities that lead to its end, where things are
    /// fast.
    pub(super) swept: Option<Stage>,
    /// The colliders that have moved.
    pub(super) moved: Vec<ColliderHandle>,
    /// The pairs that touch, if they were asked for.
    pub(super) touching: Option<Vec<ColliderPair>>,
}

impl Reel {
    pub(super) fn new(kind: SceneKind, options: &Options, typical_size: Real) -> Self {
        let driver = Observed::new(DefaultBroadPhase::new());
        let mut reel = Self {
            scene: Scene::build(kind, options.bodies(kind), options.seed),
            driver: driver.with_lists().sorted(),
            typical_size,
            is_new: true,
        };
        for _ in 0..options.lead_in() {
            reel.scene.step(&mut reel.driver, &(), &());
            reel.driver.take_updates();
        }
        reel
    }

    /// The time of a step.
    pub(super) fn dt(&self) -> Real {
        self.scene.world.params.dt
    }

    /// The next step, in which what touches at its end touches.
    pub(super) fn next(&mut self, wants_truth: bool) -> Frame {
        self.scene.step(&mut self.driver, &(), &());
        let moved = self.moved();
        let world = &self.scene.world;
        let touching = wants_truth.then(|| Truth::of(world, self.typical_size).into_touching());
        Frame {
            stage: Stage::of(world),
            swept: None,
            moved,
            touching,
        }
    }

    /// The next step, in which what meets at any time between its beginning and its end touches. Everything goes straight,
    /// without turning, and no continuous collision detection stops it.
    pub(super) fn next_straight(&mut self, wants_truth: bool) -> Frame {
        self.scene.prepare();
        let world = &mut self.scene.world;
        let is_continuous =
            |body: &RigidBody| body.is_ccd_enabled() || body.soft_ccd_prediction() > 0.0;
        let bodies = world.bodies.iter();
        let continuous: Vec<_> = bodies
            .filter_map(|(handle, body)| is_continuous(body).then_some(handle))
            .collect();
        for handle in continuous {
            let body = &mut world.bodies[handle];
            body.enable_ccd(false);
            body.set_soft_ccd_prediction(0.0);
        }
        let starts = Motions::starts(world);
        world.step(&mut self.driver, &(), &());
        let motions = Motions::new(world, starts);
        let mut moved = self.moved();
        let world = &self.scene.world;
        moved.extend(motions.handles());
        Frame {
            stage: motions.at_end(world),
            swept: Some(motions.at_start(world)),
            moved,
            touching: wants_truth.then(|| motions.touching(world, self.typical_size)),
        }
    }

    /// What the driver was told of in the last step, new colliders included; at first, all that there are.
    fn moved(&mut self) -> Vec<ColliderHandle> {
        let updates = self.driver.take_updates().into_iter();
        if std::mem::take(&mut self.is_new) {
            let colliders = self.scene.world.colliders.iter();
            return colliders.map(|(handle, _)| handle).collect();
        }
        updates.flat_map(|update| update.modified).collect()
    }
}
