//! What still moves although it should rest.

use super::space::{Place, distance, place};
use super::{Gauge, Reading, Tally, World};

/// The mean speed of what should rest.
pub(crate) struct Rest {
    from: f64,
    speeds: Tally,
}

impl Rest {
    /// From this time on.
    pub(crate) fn new(from: f64) -> Self {
        Self {
            from,
            speeds: Tally::default(),
        }
    }
}

impl Gauge for Rest {
    fn look(&mut self, world: &World, time: f64) {
        if time <= self.from {
            return;
        }
        let still: Place = place(|_| 0.0);
        for (_, body) in world.bodies.iter().filter(|(_, body)| body.is_dynamic()) {
            let velocity = body.linvel();
            let velocity = place(|axis| f64::from(velocity[axis]));
            self.speeds.add(distance(velocity, still));
        }
    }

    fn read(&self) -> Vec<Reading> {
        vec![Reading {
            name: "mean speed at rest, units a second",
            value: self.speeds.mean(),
        }]
    }
}
