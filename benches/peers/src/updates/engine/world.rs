//! Colliders on dynamic bodies, and a broad phase that follows them: one source, compiled once for each version
//! of Rapier and each dimension.

use super::rapier::prelude::*;
use crate::clock::Clock;
use crate::pair_set::PairSet;
use crate::updates::choreography::Choreography;
use crate::updates::peer::Peer;
use std::collections::HashSet;
use std::hint::black_box;
use std::time::Duration;

/// How a version of Rapier tells its broad phase of colliders.
pub(super) trait BroadPhaseOfEngine {
    /// Of all colliders, at the beginning.
    fn introduce(&mut self, world: &mut World);

    /// Of the listed ones, which have moved: what the engine has done by then, whatever its broad phase.
    fn prepare(&mut self, _: &World) {}

    /// Of the listed ones, which have moved.
    fn update(&mut self, world: &mut World);

    /// How much of the next update could be done beside the solver.
    fn deferred(&mut self, _: &World) -> Duration {
        Duration::ZERO
    }
}

/// The parts of Rapier that a broad phase looks at.
pub(super) struct World {
    pub(super) params: IntegrationParameters,
    pub(super) bodies: RigidBodySet,
    pub(super) colliders: ColliderSet,
    /// The handles of all, in order.
    all: Vec<(RigidBodyHandle, ColliderHandle)>,
    stride: Option<usize>,
    /// All colliders before the first frame, then those that may move.
    pub(super) listed: Vec<ColliderHandle>,
    pub(super) clock: Clock,
    /// What the update has to say.
    pub(super) events: Vec<BroadPhasePairEvent>,
}

impl World {
    fn new(start: &Choreography<DIM>) -> Self {
        let (mut bodies, mut colliders) = (RigidBodySet::new(), ColliderSet::new());
        let insert = |(&center, side): (&[f32; DIM], &f32)| {
            let half = [side / 2.0; DIM];
            let body = RigidBodyBuilder::dynamic().translation(Vector::from(center));
            let body = bodies.insert(body);
            // A shape each, as different things have.
            let cuboid = SharedShape::new(Cuboid::new(Vector::from(half)));
            let collider = ColliderBuilder::new(cuboid);
            let collider = colliders.insert_with_parent(collider, body, &mut bodies);
            (body, collider)
        };
        let places = start.centers().iter().zip(start.sides());
        let all: Vec<_> = places.map(insert).collect();
        let listed = all.iter().map(|&(_, collider)| collider).collect();
        Self {
            params: IntegrationParameters::default(),
            bodies,
            colliders,
            all,
            stride: start.motion().stride(),
            listed,
            clock: Clock::for_count(start.centers().len()),
            events: Vec::new(),
        }
    }
}

/// A broad phase in its world.
pub(super) struct Driven<B> {
    pub(super) world: World,
    pub(super) broad_phase: B,
    /// All events so far.
    log: Vec<BroadPhasePairEvent>,
}

impl<B: BroadPhaseOfEngine> Driven<B> {
    /// With all colliders known to the broad phase.
    pub(super) fn new(broad_phase: B, start: &Choreography<DIM>) -> Self {
        let mut driven = Self {
            world: World::new(start),
            broad_phase,
            log: Vec::new(),
        };
        driven.broad_phase.introduce(&mut driven.world);
        driven.log.append(&mut driven.world.events);
        driven.world.listed = match driven.world.stride {
            Some(stride) => {
                let moving = driven.world.all.iter().step_by(stride);
                moving.map(|&(_, collider)| collider).collect()
            }
            None => Vec::new(),
        };
        driven
    }
}

impl<B: BroadPhaseOfEngine> Peer<DIM> for Driven<B> {
    fn place(&mut self, centers: &[[f32; DIM]]) {
        let Some(stride) = self.world.stride else {
            return;
        };
        for (&(body, collider), &center) in self.world.all.iter().zip(centers).step_by(stride) {
            let center = Vector::from(center);
            self.world.colliders[collider].set_translation(center);
            self.world.bodies[body].set_translation(center, false);
        }
    }

    fn update(&mut self) -> Duration {
        self.broad_phase.prepare(&self.world);
        let clock = self.world.clock;
        let elapsed = clock.time(|| self.broad_phase.update(&mut self.world));
        black_box(&self.world.events);
        self.log.append(&mut self.world.events);
        elapsed
    }

    fn deferred(&mut self) -> Duration {
        self.broad_phase.deferred(&self.world)
    }

    fn held_pairs(&self) -> PairSet {
        // The two of a pair may come in either order.
        let indices = |pair: &ColliderPair| {
            let index = |collider: ColliderHandle| collider.into_raw_parts().0;
            let (a, b) = (index(pair.collider1), index(pair.collider2));
            [a.min(b), a.max(b)]
        };
        let mut held = HashSet::new();
        for event in &self.log {
            match event {
                BroadPhasePairEvent::AddPair(pair) => held.insert(indices(pair)),
                BroadPhasePairEvent::DeletePair(pair) => held.remove(&indices(pair)),
            };
        }
        PairSet::new(held)
    }
}
