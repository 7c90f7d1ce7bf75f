//! The scenes: their names and their sizes.

use clap::ValueEnum;
use serde::Serialize;

/// What is simulated; it is known what should come out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Scene {
    /// Chains of capsules fall over obstacles; their joints should hold
    Ropes,
    /// Balls and boxes fall into a walled box; they should rest, and not in each other
    Pile,
    /// Grains run through a hole in a floor onto another floor; none should leave through a wall
    Hopper,
    /// Towers of ten boxes, which should stand where they were built
    Stack,
    /// Balls at 10 to 160 a second hit a thin wall; none should pass
    Bullets,
    /// The same with soft CCD
    BulletsSoftCcd,
    /// The same with CCD
    BulletsCcd,
    /// Single pendulums should swing by the cosine, and chains should keep their energy
    Pendulum,
    /// Grains at rest between walls without friction; the floor should bear their weight
    Silo,
}

impl Scene {
    /// The name in tables and on the command line.
    pub(crate) fn name(self) -> String {
        let value = self.to_possible_value();
        value.map_or_else(String::new, |value| value.get_name().to_owned())
    }

    /// How many bodies there are, about.
    pub(crate) const fn bodies(self) -> usize {
        match self {
            Self::Stack | Self::Silo => 120,
            Self::Pendulum => 100,
            _ => 200,
        }
    }

    /// How many seconds are simulated.
    pub(crate) const fn seconds(self) -> f64 {
        match self {
            Self::Bullets | Self::BulletsSoftCcd | Self::BulletsCcd => 1.2,
            _ => 2.0,
        }
    }
}
