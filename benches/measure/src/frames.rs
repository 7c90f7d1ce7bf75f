//! A world of colliders that are moved from frame to frame: one source, compiled once for each engine and dimension.

use super::engine::Driven;
use super::rapier::prelude::*;
use crate::worlds::{Case, Motion};
use std::hint::black_box;
use std::time::Duration;
use unisize_scenes::DriftingBoxes;

/// Far enough beyond any margin to renew every box.
const LEAP: Real = 0.1;

/// Half of the smallest margin, which is 0.01 in Rapier 0.27.
const NUDGE: Real = 0.005;

/// The parts of Rapier that a broad phase looks at, and what it says.
pub(crate) struct World {
    pub(crate) params: IntegrationParameters,
    pub(crate) bodies: RigidBodySet,
    pub(crate) colliders: ColliderSet,
    pub(crate) events: Vec<BroadPhasePairEvent>,
    /// How many colliders there are.
    pub(crate) count: usize,
}

impl World {
    pub(crate) fn new(count: usize) -> Self {
        Self {
            params: IntegrationParameters::default(),
            bodies: RigidBodySet::new(),
            colliders: ColliderSet::new(),
            events: Vec::new(),
            count,
        }
    }
}

/// Cubes, and how they move.
pub(crate) struct Frames {
    pub(crate) world: World,
    motion: Motion,
    boxes: DriftingBoxes<DIM>,
    frame: usize,
    /// Those that may move.
    moving: Vec<ColliderHandle>,
}

impl Frames {
    /// All colliders before the first frame, already known to the broad phase.
    pub(crate) fn new(case: &Case, broad_phase: &mut impl Driven) -> Self {
        let boxes = DriftingBoxes::new(case.count, case.density, 7);
        let mut world = World::new(case.count);
        let mut insert = |min: &[Real; DIM]| {
            // A shape each, as different things have.
            let cuboid = Cuboid::new(Vector::from([DriftingBoxes::<DIM>::SIZE / 2.0; DIM]));
            let collider = ColliderBuilder::new(SharedShape::new(cuboid))
                // Otherwise the narrow phase would drop the pairs of colliders without bodies.
                .active_collision_types(ActiveCollisionTypes::all());
            let center = Vector::from(center(min));
            if !case.bodies {
                return world.colliders.insert(collider.translation(center));
            }
            let body = RigidBodyBuilder::dynamic().translation(center);
            let body = world.bodies.insert(body);
            let bodies = &mut world.bodies;
            world.colliders.insert_with_parent(collider, body, bodies)
        };
        let all: Vec<_> = boxes.mins().iter().map(&mut insert).collect();
        broad_phase.follow(&mut world, &all, &[], &[]);
        let moving = all.into_iter().step_by(case.motion.stride()).collect();
        Self {
            world,
            motion: case.motion,
            boxes,
            frame: 0,
            moving,
        }
    }

    /// Moves the colliders on by one frame, and returns how long the broad phase takes to process it.
    pub(crate) fn advance(&mut self, broad_phase: &mut impl Driven) -> Duration {
        let offset = match self.motion {
            // The first frame moves every box out of its place, since only then does it get a margin.
            Motion::InMargin => LEAP + NUDGE * (self.frame % 2) as Real,
            _ => {
                self.boxes.advance();
                0.0
            }
        };
        self.frame += 1;
        let moving = self.boxes.mins().iter().step_by(self.motion.stride());
        for (min, &handle) in moving.zip(&self.moving) {
            let mut center = center(min);
            center[0] += offset;
            let center = Vector::from(center);
            let collider = &mut self.world.colliders[handle];
            collider.set_translation(center);
            if let Some(parent) = collider.parent() {
                self.world.bodies[parent].set_translation(center, false);
            }
        }
        self.world.events.clear();
        let time = broad_phase.follow(&mut self.world, &[], &self.moving, &[]);
        black_box(&self.world.events);
        time
    }
}

fn center(min: &[Real; DIM]) -> [Real; DIM] {
    min.map(|x| x + DriftingBoxes::<DIM>::SIZE / 2.0)
}
