//! Energy that comes out of nothing, or goes where none should.

use super::{Gauge, Reading, World, energies};

/// The change of energy, relative to what was put in.
pub(crate) struct Energy {
    /// Whether a loss is an error too: it is not where bodies rub and bounce.
    is_kept: bool,
    start: f64,
    put_in: f64,
    largest: f64,
}

impl Energy {
    /// Whatever is gained is an error. What was put in is all energy at the start, above height zero if there is
    /// gravity.
    pub(crate) fn gained(world: &World) -> Self {
        let start = energies(world).iter().sum();
        Self {
            is_kept: false,
            start,
            put_in: start,
            largest: 0.0,
        }
    }

    /// A loss is an error as well.
    pub(crate) fn kept(world: &World, put_in: f64) -> Self {
        Self {
            is_kept: true,
            put_in,
            ..Self::gained(world)
        }
    }
}

impl Gauge for Energy {
    fn look(&mut self, world: &World, _time: f64) {
        let change = energies(world).iter().sum::<f64>() - self.start;
        let error = if self.is_kept { change.abs() } else { change };
        let error = error / self.put_in;
        self.largest = match error.is_nan() {
            true => f64::INFINITY,
            false => self.largest.max(error),
        };
    }

    fn read(&self) -> Vec<Reading> {
        vec![Reading {
            name: match self.is_kept {
                true => "change of energy, of what was put in",
                false => "energy gained, of what was put in",
            },
            value: self.largest,
        }]
    }
}
