//! Colliders that move, appear, disappear and get NaN positions, without a simulation. One source for all flavours: the module that includes
//! it imports the engine as `rapier`.
//!
//! All arithmetic is addition, subtraction and multiplication, so it is the same on every platform.

use oorandom::Rand32;

use super::UnisizeBroadPhase;
use super::rapier::prelude::*;

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
    pub(super) velocities: Vec<Vector<Real>>,
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
            let ball = ball(radius).translation(place);
            crowd.handles.push(crowd.colliders.insert(ball));
            let velocity = Vector::from_fn(|_, _| (crowd.share() - 0.5) * 2.0 * speed);
            crowd.velocities.push(velocity);
        }
        crowd.modified = crowd.handles.clone();
        crowd
    }

    /// A number in `0..1`.
    fn share(&mut self) -> Real {
        self.random.rand_float() as Real
    }

    fn somewhere(&mut self) -> Vector<Real> {
        Vector::from_fn(|_, _| self.share() * self.side)
    }

    /// Moves every `stride`-th collider, and changes a few in other ways.
    pub(super) fn advance(&mut self, stride: usize) {
        self.modified.clear();
        self.removed.clear();
        for i in (0..self.handles.len()).step_by(stride) {
            match self.random.rand_range(0..400) {
                0 => self.velocities[i] = -self.velocities[i],
                1 => self.place(i, Vector::repeat(Real::NAN)),
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
                    let mut place =
                        self.colliders[self.handles[i]].translation() + self.velocities[i];
                    if place.iter().any(|x| x.is_nan()) {
                        place = self.somewhere();
                    }
                    for k in 0..place.len() {
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

    pub(super) fn place(&mut self, i: usize, place: Vector<Real>) {
        self.colliders[self.handles[i]].set_translation(place);
    }

    /// Removes a collider and inserts another one.
    fn replace(&mut self, i: usize) {
        let (mut islands, handle) = (IslandManager::new(), self.handles[i]);
        self.colliders
            .remove(handle, &mut islands, &mut self.bodies, false);
        self.removed.push(handle);
        let ball = ball(0.5).translation(self.somewhere());
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
