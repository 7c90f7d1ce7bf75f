//! One simulation: what it is of, and what came of it.

use crate::finder::Finder;
use serde::Serialize;
use unisize_scenes::SceneKind;

/// One simulation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Case {
    pub(crate) kind: SceneKind,
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
