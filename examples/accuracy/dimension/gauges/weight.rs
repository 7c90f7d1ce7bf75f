//! What a floor bears, which should be the weight of what rests on it.

use super::scenes::rapier::prelude::*;
use super::space::GRAVITY;
use super::version::impulse;
use super::{Gauge, Reading, Tally, World};

/// The mean force on a floor, compared with the weight of all dynamic bodies.
pub(crate) struct Weight {
    floor: ColliderHandle,
    from: f64,
    forces: Tally,
    weight: f64,
}

impl Weight {
    /// On this floor, from this time on.
    pub(crate) fn new(floor: ColliderHandle, from: f64) -> Self {
        Self {
            floor,
            from,
            forces: Tally::default(),
            weight: 0.0,
        }
    }
}

impl Gauge for Weight {
    fn look(&mut self, world: &World, time: f64) {
        if time <= self.from {
            return;
        }
        let pairs = world.narrow_phase.contact_pairs_with(self.floor);
        let impulses = pairs.map(|pair| f64::from(impulse(pair)));
        self.forces
            .add(impulses.sum::<f64>() / f64::from(world.params.dt));
        let bodies = world.bodies.iter().map(|(_, body)| body);
        let masses = bodies.filter(|body| body.is_dynamic());
        self.weight = masses.map(|body| f64::from(body.mass()) * GRAVITY).sum();
    }

    fn read(&self) -> Vec<Reading> {
        vec![Reading {
            name: "weight on the floor that is missing or too much",
            value: (self.forces.mean() / self.weight - 1.0).abs(),
        }]
    }
}
