//! Whether a scene still behaves physically: a few plain numbers, and bounds on them.

use super::rapier::{math::DIM, prelude::*};
use super::scene::Scene;
use super::space::{Point, UP, Vector, along, largest, length, own};
use super::stage::Link;
use super::version;

/// By how much the energy of a scene may exceed what it had and what its script brought in.
///
/// Rapier pushes bodies apart that overlap, which makes energy out of nothing; piles gain about a percent.
const ENERGY_GROWTH: f64 = 1.1;

/// The energy per mass that is allowed beyond that, in squared length units per squared second.
///
/// It is that of one length unit per second, for scenes that start with next to none.
const ENERGY_SLACK: f64 = 0.5;

/// How far apart the two ends that a joint of a rope holds together may be, per length of a segment.
///
/// A rope that hangs at rest is at about a hundredth, one that is caught in its fall at a few tenths.
const ROPE_STRETCH: f64 = 1.0;

/// What tells a sane scene from one that exploded or leaked.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sanity {
    /// The number of bodies, fixed ones included.
    pub bodies: usize,
    /// The number of dynamic bodies that are outside of their container by more than their own size.
    pub fallen_through: usize,
    /// The number of bodies that may be outside although all is well: some bullets defeat Rapier's CCD.
    pub may_fall_through: usize,
    /// The mass of all dynamic bodies but soft ones, whose energy does not count either.
    pub mass: f64,
    /// The kinetic energy of all dynamic bodies.
    pub kinetic_energy: f64,
    /// The potential energy of all dynamic bodies above the floor.
    pub potential_energy: f64,
    /// The energy that the script brought in since the scene was built, without subtracting what it took out.
    pub supplied_energy: f64,
    /// The largest distance between the two ends that a joint of a rope holds together, relative to the
    /// length of a segment; none if there are no ropes.
    pub max_rope_stretch: Option<f64>,
    /// The number of bodies with a pose or a velocity that is not finite.
    pub not_finite: usize,
    /// The number of sleeping bodies.
    pub sleeping: usize,
}

impl Sanity {
    /// The kinetic and the potential energy.
    pub fn energy(&self) -> f64 {
        self.kinetic_energy + self.potential_energy
    }

    /// Checks the numbers against those that the scene had when it was built.
    ///
    /// Nothing may have left its container, up to [`may_fall_through`](Self::may_fall_through), or have a
    /// pose that is not finite. The energy may exceed what was there and what the script supplied by at most a
    /// tenth and half a unit per mass. The ends that a joint of a rope holds together may be at most one segment
    /// apart.
    ///
    /// # Errors
    ///
    /// A sentence on the first bound that is broken.
    pub fn verdict(&self, initial: &Self) -> Result<(), String> {
        if self.not_finite > 0 {
            return Err(format!("{} bodies are not finite", self.not_finite));
        }
        if self.fallen_through > self.may_fall_through {
            return Err(format!(
                "{} of {} bodies left their container",
                self.fallen_through, self.bodies
            ));
        }
        let supplied = self.supplied_energy - initial.supplied_energy;
        let bound = (initial.energy() + supplied) * ENERGY_GROWTH + self.mass * ENERGY_SLACK;
        if self.energy().is_nan() || self.energy() > bound {
            return Err(format!("energy {} exceeds {bound}", self.energy()));
        }
        match self.max_rope_stretch {
            Some(stretch) if stretch.is_nan() || stretch > ROPE_STRETCH => {
                Err(format!("a rope is stretched by {stretch} of a segment"))
            }
            _ => Ok(()),
        }
    }
}

impl Scene {
    /// Measures the scene in **O(n)** time.
    pub fn sanity(&self) -> Sanity {
        let mut sanity = Sanity {
            bodies: self.world.bodies.len(),
            may_fall_through: self.may_fall_through,
            supplied_energy: self.cue.supplied,
            ..Sanity::default()
        };
        for (_, body) in self.world.bodies.iter() {
            sanity.sleeping += usize::from(body.is_sleeping());
            if !is_finite(body) {
                sanity.not_finite += 1;
                continue;
            }
            if !body.is_dynamic() {
                continue;
            }
            // The mass of a soft body is unknown before the first step.
            if !version::is_soft(body) {
                let mass = f64::from(body.mass());
                let height = f64::from(body.center_of_mass()[UP] - self.cue.ground);
                let gravity = f64::from(length(self.world.gravity) * body.gravity_scale());
                sanity.mass += mass;
                sanity.kinetic_energy += f64::from(body.kinetic_energy());
                sanity.potential_energy += mass * gravity * height;
            }
            let container = &self.containers[body.user_data as usize];
            if container.is_left_by(own(body.translation()), self.size(body)) {
                sanity.fallen_through += 1;
            }
        }
        sanity.max_rope_stretch = self
            .links
            .iter()
            .filter_map(|link| self.stretch(link))
            .reduce(f64::max);
        sanity
    }

    /// The largest extent of the colliders of a body.
    fn size(&self, body: &RigidBody) -> Real {
        body.colliders()
            .iter()
            .map(|&collider| self.world.colliders[collider].shape().compute_local_aabb())
            .map(|aabb| largest(aabb.extents()))
            .fold(0.0, Real::max)
    }

    fn stretch(&self, link: &Link) -> Option<f64> {
        let joint = self.world.impulse_joints.get(link.joint)?;
        let end =
            |body: RigidBodyHandle, anchor: Point| self.world.bodies[body].position() * anchor;
        let [first, second] = link.bodies;
        let first = end(first, joint.data.local_anchor1());
        let second = end(second, joint.data.local_anchor2());
        Some(f64::from(length(second - first)) / f64::from(link.length))
    }
}

fn is_finite(body: &RigidBody) -> bool {
    let is_finite = |vector: Vector| (0..DIM).all(|axis| vector[axis].is_finite());
    let turned = |axis| body.position() * Point::from(along(axis, 1.0)) - Point::default();
    is_finite(own(body.linvel())) && (0..DIM).all(|axis| is_finite(turned(axis)))
}
