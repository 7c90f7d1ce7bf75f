//! Squares on dynamic bodies, followed by a broad phase: one source, compiled once for each version of Rapier.

use super::rapier::prelude::*;
use super::{COLOR, NAME, introduce, update};
use crate::method::Method;
use anyhow::{Result, ensure};
use std::time::{Duration, Instant};
use unisize::Aabb;
use unisize_charts::RGBColor;

/// The parts of Rapier that a broad phase reads.
pub(super) struct World {
    pub(super) params: IntegrationParameters,
    pub(super) bodies: RigidBodySet,
    pub(super) colliders: ColliderSet,
    /// All colliders.
    pub(super) listed: Vec<ColliderHandle>,
    pub(super) events: Vec<BroadPhasePairEvent>,
    parents: Vec<RigidBodyHandle>,
}

/// Rapier's broad phase in its world.
pub(crate) struct Hierarchy {
    world: World,
    broad_phase: DefaultBroadPhase,
    pairs: usize,
}

impl Hierarchy {
    /// All squares are inserted into the broad phase.
    pub(crate) fn new(mins: &[[f32; 2]]) -> Self {
        let (mut bodies, mut colliders) = (RigidBodySet::new(), ColliderSet::new());
        let (mut parents, mut listed) = (Vec::new(), Vec::new());
        for mins in mins {
            let place = Vector::from(mins.map(|x| x + 0.5));
            let body = bodies.insert(RigidBodyBuilder::dynamic().translation(place));
            let collider = ColliderBuilder::cuboid(0.5, 0.5);
            parents.push(body);
            listed.push(colliders.insert_with_parent(collider, body, &mut bodies));
        }
        let mut hierarchy = Self {
            world: World {
                params: IntegrationParameters::default(),
                bodies,
                colliders,
                listed,
                events: Vec::new(),
                parents,
            },
            broad_phase: DefaultBroadPhase::new(),
            pairs: 0,
        };
        introduce(&mut hierarchy.broad_phase, &mut hierarchy.world);
        hierarchy.count();
        hierarchy
    }

    /// Counts the pairs by the events.
    fn count(&mut self) {
        for event in self.world.events.drain(..) {
            match event {
                BroadPhasePairEvent::AddPair(_) => self.pairs += 1,
                BroadPhasePairEvent::DeletePair(_) => self.pairs = self.pairs.saturating_sub(1),
            }
        }
    }
}

impl Method<2> for Hierarchy {
    fn name(&self) -> &'static str {
        NAME
    }

    fn color(&self) -> RGBColor {
        COLOR
    }

    fn run(&mut self, boxes: &[Aabb<f32, 2>]) -> Result<Duration> {
        let world = &mut self.world;
        ensure!(
            boxes.len() == world.listed.len(),
            "the number of boxes has changed"
        );
        for ((aabb, &collider), &body) in boxes.iter().zip(&world.listed).zip(&world.parents) {
            let place = Vector::from(aabb.mins.map(|x| x + 0.5));
            world.colliders[collider].set_translation(place);
            world.bodies[body].set_translation(place, false);
        }
        let start = Instant::now();
        update(&mut self.broad_phase, world);
        let elapsed = start.elapsed();
        self.count();
        Ok(elapsed)
    }

    fn pair_count(&self) -> usize {
        self.pairs
    }

    fn exact_pairs(&self) -> Option<&[[u32; 2]]> {
        None
    }
}
