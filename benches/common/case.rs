//! What happens to colliders between two updates, and how large they are: alike for every engine and dimension.

use crate::clock::Clock;

/// Which colliders are listed, and how they have moved.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Motion {
    /// One collider in this many drifts on, and only those are listed.
    OneIn(usize),
    /// All are listed, and none has left the margin around its box.
    InMargin,
    /// None is listed.
    #[allow(dead_code, reason = "of the peers alone")]
    Nothing,
}

impl Motion {
    pub(crate) fn name(self) -> String {
        match self {
            Self::OneIn(1) => "all move".to_owned(),
            Self::OneIn(stride) => format!("one in {stride} moves"),
            Self::InMargin => "all in their margin".to_owned(),
            Self::Nothing => "nothing listed".to_owned(),
        }
    }

    /// The distance, in indices, from one listed collider to the next.
    pub(crate) fn stride(self) -> usize {
        match self {
            Self::OneIn(stride) => stride,
            Self::InMargin => 1,
            Self::Nothing => usize::MAX,
        }
    }
}

/// How large the cubes are.
#[derive(Clone, Copy, PartialEq)]
#[allow(dead_code, reason = "all but the first are of the peers alone")]
pub(crate) enum Sizes {
    /// All have sides of 1.
    One,
    /// Sides between 1 and 4.
    OneToFour,
    /// One in a hundred is 100 times as large as the others.
    FewLarge,
}

impl Sizes {
    /// The side of each of so many cubes. Equal arguments give equal sides.
    pub(crate) fn sides(self, count: usize) -> Vec<f32> {
        let side = |i: usize| match self {
            // Fibonacci hashing: as good as random, and uniform.
            Self::OneToFour => {
                let hash = (i as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 40;
                1.0 + 3.0 * hash as f32 / (1 << 24) as f32
            }
            Self::FewLarge if i % 100 < 1 => 100.0,
            Self::One | Self::FewLarge => 1.0,
        };
        (0..count).map(side).collect()
    }
}

/// Colliders and their motion. Equal cases make equal frames.
#[derive(Clone, Copy)]
pub(crate) struct Case {
    pub(crate) count: usize,
    /// The part of the area or volume that they would fill if they did not overlap.
    pub(crate) density: f64,
    pub(crate) motion: Motion,
    pub(crate) sizes: Sizes,
    /// Whether each is on a dynamic body, or has none.
    pub(crate) bodies: bool,
    pub(crate) clock: Clock,
}
