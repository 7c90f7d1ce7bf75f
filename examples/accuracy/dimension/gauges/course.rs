//! How far bodies are from a course that is known.

use super::scenes::rapier::prelude::*;
use super::space::place_of;
use super::{Gauge, Reading, Tally, World};

/// A body, and where it should be along the first axis at each time.
pub(crate) struct Followed {
    pub(crate) body: RigidBodyHandle,
    pub(crate) course: Box<dyn Fn(f64) -> f64>,
}

/// The mean distance from the known course along the first axis, where it is largest over time.
pub(crate) struct Course {
    followed: Vec<Followed>,
    length: f64,
    largest: f64,
}

impl Course {
    /// For courses of this length.
    pub(crate) fn new(followed: Vec<Followed>, length: f64) -> Self {
        Self {
            followed,
            length,
            largest: 0.0,
        }
    }
}

impl Gauge for Course {
    fn look(&mut self, world: &World, time: f64) {
        let mut errors = Tally::default();
        for followed in &self.followed {
            let place = place_of(&world.bodies[followed.body])[0];
            errors.add((place - (followed.course)(time)).abs() / self.length);
        }
        self.largest = self.largest.max(errors.mean());
    }

    fn read(&self) -> Vec<Reading> {
        vec![Reading {
            name: "distance from the known course, of its length",
            value: self.largest,
        }]
    }
}
