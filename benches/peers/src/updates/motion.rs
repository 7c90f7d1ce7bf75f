//! What happens to the colliders between two updates.

use std::fmt;

#[derive(Clone, Copy)]
pub(crate) enum Motion {
    /// One of so many drifts on, and only these are listed.
    OneIn(usize),
    /// All are listed, and none has left the margin around its box.
    InMargin,
    /// None is listed.
    Nothing,
}

impl Motion {
    pub(crate) const ALL: [Self; 5] = [
        Self::OneIn(1),
        Self::OneIn(10),
        Self::OneIn(100),
        Self::InMargin,
        Self::Nothing,
    ];

    /// The distance, in indices, from one listed collider to the next; `None` if there are none.
    pub(crate) fn stride(self) -> Option<usize> {
        match self {
            Self::OneIn(stride) => Some(stride),
            Self::InMargin => Some(1),
            Self::Nothing => None,
        }
    }
}

impl fmt::Display for Motion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OneIn(1) => f.write_str("all move"),
            Self::OneIn(stride) => write!(f, "one in {stride} moves"),
            Self::InMargin => f.write_str("all in their margin"),
            Self::Nothing => f.write_str("nothing listed"),
        }
    }
}
