//! How large the colliders are.

use std::fmt;

#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Sizes {
    /// All have sides of 1.
    One,
    /// Sides between 1 and 4, cubes.
    OneToFour,
    /// One in a hundred is 100 times as large as the others.
    FewLarge,
}

impl Sizes {
    pub(crate) const ALL: [Self; 3] = [Self::One, Self::OneToFour, Self::FewLarge];

    /// The side of each of so many cubes. Equal arguments give equal sides.
    pub(crate) fn sides(self, count: usize) -> Vec<f32> {
        let side = |i: usize| match self {
            Self::One => 1.0,
            // Fibonacci hashing: as good as random, and uniform.
            Self::OneToFour => {
                let hash = (i as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 40;
                1.0 + 3.0 * hash as f32 / (1 << 24) as f32
            }
            Self::FewLarge if i.is_multiple_of(100) => 100.0,
            Self::FewLarge => 1.0,
        };
        (0..count).map(side).collect()
    }
}

impl fmt::Display for Sizes {
    /// As an addition to other words.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::One => Ok(()),
            Self::OneToFour => f.write_str(", sizes 1 to 4"),
            Self::FewLarge => f.write_str(", one in 100 is 100 times as large"),
        }
    }
}
