//! Colliders that move, appear, disappear and get NaN positions, without a simulation. One source for every flavour: the module that
//! includes it imports the engine as `rapier`, and the differences of its version as `version`.
//!
//! All arithmetic is addition, subtraction and multiplication, so it is the same on every platform.

use std::array::from_fn;

use oorandom::Rand32;

use super::rapier::prelude::*;
use super::{UnisizeBroadPhase, version};

/// A collider without a body. It counts as fixed, and fixed colliders form pairs only if their collision types allow it.
fn ball(radius: Real) -> ColliderBuilder {
    ColliderBuilder::ball(radius).active_collision_types(ActiveCollisionTypes::all())
}

/// The colliders, and the lists of the next update.
#[derive(Clone)]
pub(super) struct Crowd {
    pub(super) colliders: ColliderSet,
    pub(super) bodies: RigidBodySet,
    pub(super) handles: Vec<ColliderHandle>,
    pub(super) velocities: Vec<[Real; DIM]>,
    pub(super) modified: Vec<ColliderHandle>,
    removed: Vec<ColliderHandle>,
    side: Real,
    random: Rand32,
}

impl Crowd {
    pub(super) fn new(count: usize, side: Real, speed: Real) -> Self {
        let mut crowd = Self {
            colliders: ColliderSet::new(),
            bodies: RigidBodySet::new(),
            handles: Vec::new(),
            velocities: Vec::new(),
            modified: Vec::new(),
            removed: Vec::new(),
            side,
            random: Rand32::new(3),
        };
        for i in 0..count {
            // One in a hundred is much larger than the rest.
            let radius = if i % 100 == 50 { 4.0 } else { 0.5 };
            let place = crowd.somewhere();
            let ball = ball(radius).translation(version::vector(place));
            crowd.handles.push(crowd.colliders.insert(ball));
            let velocity = from_fn(|_| (crowd.share() - 0.5) * 2.0 * speed);
            crowd.velocities.push(velocity);
        }
        crowd.modified = crowd.handles.clone();
        crowd
    }

    /// A number in `0..1`.
    fn share(&mut self) -> Real {
        self.random.rand_float() as Real
    }

    fn somewhere(&mut self) -> [Real; DIM] {
        from_fn(|_| self.share() * self.side)
    }

    /// Moves every `stride`-th collider, and changes a few in other ways.
    pub(super) fn advance(&mut self, stride: usize) {
        self.modified.clear();
        self.removed.clear();
        for i in (0..self.handles.len()).step_by(stride) {
            match self.random.rand_range(0..400) {
                0 => self.turn_back(i),
                1 => self.place(i, [Real::NAN; DIM]),
                2 => self.replace(i),
                3 => {
                    let place = self.somewhere();
                    self.place(i, place);
                }
                4 => {
                    let collider = &mut self.colliders[self.handles[i]];
                    collider.set_enabled(!collider.is_enabled());
                }
                _ => {
                    let before = version::coordinates(&self.colliders[self.handles[i]]);
                    let mut place = from_fn(|k| before[k] + self.velocities[i][k]);
                    if place.iter().any(|x| x.is_nan()) {
                        place = self.somewhere();
                    }
                    for k in 0..DIM {
                        if place[k] < 0.0 || place[k] > self.side {
                            self.velocities[i][k] = -self.velocities[i][k];
                        }
                    }
                    self.place(i, place);
                }
            }
            self.modified.push(self.handles[i]);
        }
    }

    pub(super) fn place(&mut self, i: usize, place: [Real; DIM]) {
        self.colliders[self.handles[i]].set_translation(version::vector(place));
    }

    pub(super) fn turn_back(&mut self, i: usize) {
        self.velocities[i] = self.velocities[i].map(|speed| -speed);
    }

    /// Removes a collider and inserts another one.
    fn replace(&mut self, i: usize) {
        let handle = self.handles[i];
        version::remove(&mut self.colliders, &mut self.bodies, handle);
        self.removed.push(handle);
        let place = version::vector(self.somewhere());
        let ball = ball(0.5).translation(place);
        self.handles[i] = self.colliders.insert(ball);
    }

    /// Updates the broad phase. Returns the pairs of the events, and whether each begins.
    pub(super) fn update(&self, broad_phase: &mut UnisizeBroadPhase) -> Vec<(bool, ColliderPair)> {
        let mut events = Vec::new();
        broad_phase.update(
            &IntegrationParameters::default(),
            &self.colliders,
            &self.bodies,
            &self.modified,
            &self.removed,
            &mut events,
        );
        let events = events.iter().map(|event| match event {
            BroadPhasePairEvent::AddPair(pair) => (true, *pair),
            BroadPhasePairEvent::DeletePair(pair) => (false, *pair),
        });
        events.collect()
    }
}
