//! A world of colliders that are moved from frame to frame: one source, compiled once in each dimension.

use super::rapier::prelude::*;
use super::version::Driven;
use crate::Motion;
use std::hint::black_box;
use std::time::Duration;
use unisize_scenes::DriftingBoxes;

/// Gives 0.8 overlapping pairs per box in either dimension.
pub(super) const DENSITY: f64 = 1.6 / (1 << DIM) as f64;

/// Far enough beyond the margin to renew every box.
const LEAP: Real = 0.1;

/// Half the margin of both broad phases.
const NUDGE: Real = 0.005;

/// What the colliders are attached to.
#[derive(Clone, Copy)]
#[allow(dead_code, reason = "not every bench that shares this has both")]
pub(super) enum Parents {
    /// Nothing: only the colliders count.
    None,
    /// A dynamic body each.
    Dynamic,
}

/// Colliders and how they move. Equal arguments make equal frames.
pub(super) struct Frames {
    boxes: DriftingBoxes<DIM>,
    motion: Motion,
    frame: usize,
    params: IntegrationParameters,
    bodies: RigidBodySet,
    colliders: ColliderSet,
    /// Those that may move.
    moving: Vec<ColliderHandle>,
    events: Vec<BroadPhasePairEvent>,
}

impl Frames {
    /// This many colliders before the first frame, already known to the broad phase.
    pub(super) fn new(
        count: usize,
        motion: Motion,
        parents: Parents,
        broad_phase: &mut dyn Driven,
    ) -> Self {
        let boxes = DriftingBoxes::new(count, DENSITY, 7);
        let (mut bodies, mut colliders) = (RigidBodySet::new(), ColliderSet::new());
        let half = DriftingBoxes::<DIM>::SIZE / 2.0;
        let mut insert = |min: &[Real; DIM]| {
            let cuboid = SharedShape::new(Cuboid::new(Vector::from([half; DIM])));
            let collider = ColliderBuilder::new(cuboid)
                // Otherwise the narrow phase would drop the pairs of colliders without bodies.
                .active_collision_types(ActiveCollisionTypes::all());
            let center = Vector::from(center(min));
            match parents {
                Parents::None => colliders.insert(collider.translation(center)),
                Parents::Dynamic => {
                    let body = RigidBodyBuilder::dynamic().translation(center);
                    let body = bodies.insert(body);
                    colliders.insert_with_parent(collider, body, &mut bodies)
                }
            }
        };
        let all: Vec<_> = boxes.mins().iter().map(&mut insert).collect();
        let mut frames = Self {
            boxes,
            motion,
            frame: 0,
            params: IntegrationParameters::default(),
            bodies,
            colliders,
            moving: all.iter().step_by(motion.stride()).copied().collect(),
            events: Vec::new(),
        };
        frames.tell(broad_phase, [&all, &[], &[]]);
        frames
    }

    /// Moves the colliders on by one frame.
    pub(super) fn advance(&mut self) {
        let offset = match self.motion {
            Motion::OneIn(_) => {
                self.boxes.advance();
                0.0
            }
            // The first frame moves every box out of its place, since only then does it get a margin.
            Motion::InMargin => LEAP + NUDGE * (self.frame % 2) as Real,
        };
        self.frame += 1;
        let moving = self.boxes.mins().iter().step_by(self.motion.stride());
        for (min, &handle) in moving.zip(&self.moving) {
            let mut center = center(min);
            center[0] += offset;
            let center = Vector::from(center);
            let collider = &mut self.colliders[handle];
            collider.set_translation(center);
            if let Some(parent) = collider.parent() {
                self.bodies[parent].set_translation(center, false);
            }
        }
    }

    /// How long the broad phase takes to process this frame.
    pub(super) fn update(&mut self, broad_phase: &mut dyn Driven) -> Duration {
        let moving = std::mem::take(&mut self.moving);
        let time = self.tell(broad_phase, [&[], &moving, &[]]);
        self.moving = moving;
        time
    }

    /// How long an update takes after these were inserted, moved and removed.
    fn tell(&mut self, broad_phase: &mut dyn Driven, lists: [&[ColliderHandle]; 3]) -> Duration {
        self.events.clear();
        let (params, colliders, bodies) = (&self.params, &self.colliders, &self.bodies);
        let time = broad_phase.follow(params, colliders, bodies, lists, &mut self.events);
        black_box(&self.events);
        time
    }
}

fn center(min: &[Real; DIM]) -> [Real; DIM] {
    min.map(|x| x + DriftingBoxes::<DIM>::SIZE / 2.0)
}
