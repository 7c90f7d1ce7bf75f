//! A case: a small world, and the one thing in it that is taken to its limit.

/// A small world to simulate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Case {
    pub(crate) setup: Setup,
    /// The time step in seconds.
    pub(crate) dt: f64,
    /// How far from the origin it is on every axis, in units.
    pub(crate) offset: f64,
    /// How many units of length there are in a metre: all lengths, speeds and gravity are given in metres.
    pub(crate) metre: f64,
    /// `IntegrationParameters::length_unit`.
    pub(crate) length_unit: f64,
    /// How long it is simulated, in simulated seconds.
    pub(crate) seconds: f64,
}

/// What a world is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Setup {
    /// So many boxes of a metre upon each other.
    Stack(usize),
    /// Three boxes of a metre upon each other, and a heavier one of the same size upon them.
    Press { ratio: f64 },
    /// A chain of a hundred links, each half a metre long, that hangs from a hook and carries a heavier ball.
    Chain { ratio: f64 },
    /// Boxes in a closed box, each spinning at so many radians per second.
    Spin { speed: f64 },
    /// Balls that fly at a thin wall, so many metres per second fast.
    Shots { speed: f64, has_ccd: bool },
    /// Boxes that fly and spin with numbers that no sane program has, beside a stack.
    Burst { speed: f64 },
}

impl Case {
    /// A world of the usual size and time step, at the origin.
    pub(crate) const fn usual(setup: Setup) -> Self {
        Self {
            setup,
            dt: 1.0 / 60.0,
            offset: 0.0,
            metre: 1.0,
            length_unit: 1.0,
            seconds: 5.0,
        }
    }

    /// How many steps are simulated.
    pub(crate) fn steps(&self) -> usize {
        (self.seconds / self.dt).round() as usize
    }

    /// The same for a shorter time.
    pub(crate) fn lasting_at_most(mut self, seconds: f64) -> Self {
        self.seconds = self.seconds.min(seconds);
        self
    }
}
