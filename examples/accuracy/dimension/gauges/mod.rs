//! What measures an error while a stage is simulated, each in its own file.

use super::scenes::{self, World, rapier::math::DIM};
use super::space::{self, Place};
use super::version;
use crate::case::Reading;

mod course;
mod displacement;
mod energy;
mod outside;
mod penetration;
mod rest;
mod stretch;
mod weight;

pub(super) use course::{Course, Followed};
pub(super) use displacement::Displacement;
pub(super) use energy::Energy;
pub(super) use outside::Outside;
pub(super) use penetration::Penetration;
pub(super) use rest::Rest;
pub(super) use stretch::Stretch;
pub(super) use weight::Weight;

/// What measures an error.
pub(super) trait Gauge {
    /// Looks at the world after this many simulated seconds.
    fn look(&mut self, world: &World, time: f64);

    /// The errors by all that was looked at.
    fn read(&self) -> Vec<Reading>;
}

/// The mean and the largest of many errors.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    count: usize,
    sum: f64,
    largest: f64,
}

impl Tally {
    /// Counts an error. One that is not a number is infinitely large.
    fn add(&mut self, error: f64) {
        let error = if error.is_nan() { f64::INFINITY } else { error };
        self.count += 1;
        self.sum += error;
        self.largest = self.largest.max(error);
    }

    fn mean(&self) -> f64 {
        self.sum / self.count.max(1) as f64
    }
}

/// The energy of everything that is dynamic: that of motion, and the potential one in the world's gravity, above height zero.
fn energies(world: &World) -> [f64; 2] {
    let bodies = world.bodies.iter().map(|(_, body)| body);
    let bodies = bodies.filter(|body| body.is_dynamic());
    bodies.fold([0.0; 2], |[kinetic, potential], body| {
        let center = body.center_of_mass();
        let along = |axis: usize| f64::from(world.gravity[axis]) * f64::from(center[axis]);
        [
            kinetic + f64::from(body.kinetic_energy()),
            potential - f64::from(body.mass()) * (0..DIM).map(along).sum::<f64>(),
        ]
    })
}
