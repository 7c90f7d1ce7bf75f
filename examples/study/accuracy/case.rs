//! One simulation: what it is of, and what came of it.

use super::scene::Scene;
use crate::finder::{Finder, Setting};
use crate::{FINDERS, SCALARS};
use serde::Serialize;

/// The numbers that Rapier computes with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Scalar {
    F32,
    // Without the features for it there is none.
    #[allow(dead_code)]
    F64,
}

/// A way to simulate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Method {
    pub(crate) finder: Finder,
    pub(crate) scalar: Scalar,
}

impl Method {
    /// All of them: what misses pairs is simulated with the numbers that most programs have.
    pub(crate) fn all() -> Vec<Self> {
        let with = |scalar, finder| Self { finder, scalar };
        let scalars = SCALARS.iter().flat_map(|&scalar| {
            let is_exact = move |finder: &&Finder| {
                scalar == Scalar::F32
                    || [Finder::Rapier, Finder::Unisize(Setting::DEFAULT)].contains(finder)
            };
            let finders = FINDERS.iter().filter(is_exact);
            finders.map(move |&finder| with(scalar, finder))
        });
        scalars.collect()
    }

    /// Its name in tables and charts.
    pub(crate) fn name(self) -> String {
        match self.scalar {
            Scalar::F32 => self.finder.name(),
            Scalar::F64 => format!("{}, f64", self.finder.name()),
        }
    }
}

/// One simulation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Case {
    pub(crate) scene: Scene,
    pub(crate) finder: Finder,
    /// Whether the events of an update are sorted before Rapier hears of them.
    pub(crate) is_sorted: bool,
    /// Steps per simulated second; a multiple of [`FRAMES`].
    pub(crate) frequency: u32,
    /// What decides the starting positions, up to a little.
    pub(crate) seed: u64,
    /// About how many bodies.
    pub(crate) bodies: usize,
    /// How long, in simulated seconds.
    pub(crate) seconds: f64,
}

/// So often in a simulated second are errors measured, whatever the time step.
pub(crate) const FRAMES: u32 = 30;

/// What came of a simulation.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Run {
    /// Milliseconds of the processor for one simulated second, without those of measuring.
    pub(crate) milliseconds: f64,
    /// By name, the most telling one first.
    pub(crate) errors: Vec<Reading>,
    /// How many pairs were found and how many of them were lost, where some are lost on purpose.
    pub(crate) pairs: Option<[usize; 2]>,
    /// A hash of the poses and velocities of all bodies at the end. Where it differs, the runs do.
    pub(crate) state: u64,
}

/// A measured error.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(crate) struct Reading {
    /// What it is, with its unit.
    pub(crate) name: &'static str,
    pub(crate) value: f64,
}

impl Reading {
    /// The reading, or infinity if it is not a number, which would compare with nothing.
    pub(crate) fn or_infinite(self) -> Self {
        let value = match self.value.is_nan() {
            true => f64::INFINITY,
            false => self.value,
        };
        Self { value, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::Reading;

    #[test]
    fn what_is_not_a_number_is_infinitely_wrong() {
        let read = |value| {
            let reading = Reading {
                name: "an error",
                value,
            };
            reading.or_infinite().value
        };
        assert_eq!(read(f64::NAN), f64::INFINITY);
        assert_eq!(read(1.5), 1.5);
    }
}
