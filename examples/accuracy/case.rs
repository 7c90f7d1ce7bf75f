//! One simulation: what it is of, and what came of it.

use crate::scene::Scene;

/// What finds the pairs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Finder {
    /// Rapier's own broad phase.
    Rapier,
    /// unisize with its default settings.
    Unisize,
    /// The negative control: Rapier's own, of whose pairs some are lost.
    Control,
}

/// The control loses one of so many pairs.
pub(crate) const LOST_ONE_IN: u32 = 1000;

impl Finder {
    pub(crate) const ALL: [Self; 3] = [Self::Rapier, Self::Unisize, Self::Control];

    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Rapier => "Rapier's",
            Self::Unisize => "unisize",
            Self::Control => "control",
        }
    }
}

/// The numbers that Rapier computes with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scalar {
    F32,
    // Only the program for Rapier 0.27 has it.
    #[allow(dead_code)]
    F64,
}

impl Scalar {
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
        }
    }
}

/// A way to simulate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Method {
    pub(crate) finder: Finder,
    pub(crate) scalar: Scalar,
}

impl Method {
    /// All of them: the control is simulated with the scalar that most programs have.
    pub(crate) fn all(scalars: &[Scalar]) -> Vec<Self> {
        let methods = scalars
            .iter()
            .flat_map(|&scalar| Finder::ALL.map(|finder| Self { finder, scalar }));
        methods
            .filter(|method| method.finder != Finder::Control || method.scalar == Scalar::F32)
            .collect()
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
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Run {
    /// Milliseconds of the processor for one simulated second, without those of measuring.
    pub(crate) milliseconds: f64,
    /// By name, the most telling one first.
    pub(crate) errors: Vec<Reading>,
    /// How many pairs the control found, and how many of them it lost.
    pub(crate) pairs: Option<[usize; 2]>,
    /// A hash of the poses and velocities of all bodies at the end. Where it differs, the runs do.
    pub(crate) state: u64,
}

/// A measured error.
#[derive(Clone, Copy, Debug, PartialEq)]
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
