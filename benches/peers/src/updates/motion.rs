//! What happens to the colliders between two updates.

use std::fmt;

#[derive(Clone, Copy)]
pub(crate) enum Motion {
    /// One of so many drifts on, and only these are listed.
    OneIn(usize),
    /// All drift on, and have done so for a while: trees that were good have aged.
    AllForLong,
    /// All are listed, and none has left the margin around its box.
    InMargin,
    /// None is listed.
    Nothing,
}

impl Motion {
    pub(crate) const ALL: [Self; 6] = [
        Self::OneIn(1),
        Self::AllForLong,
        Self::OneIn(10),
        Self::OneIn(100),
        Self::InMargin,
        Self::Nothing,
    ];

    /// The distance, in indices, from one listed collider to the next; `None` if there are none.
    pub(crate) fn stride(self) -> Option<usize> {
        match self {
            Self::OneIn(stride) => Some(stride),
            Self::AllForLong | Self::InMargin => Some(1),
            Self::Nothing => None,
        }
    }

    /// Frames before those that are measured: the first updates insert, and trees go on being mended for some
    /// more.
    pub(crate) fn frames_to_settle(self) -> usize {
        match self {
            Self::AllForLong => 400,
            _ => 5,
        }
    }
}

impl fmt::Display for Motion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OneIn(1) => f.write_str("all move"),
            Self::AllForLong => write!(f, "all move, after {} frames", self.frames_to_settle()),
            Self::OneIn(stride) => write!(f, "one in {stride} moves"),
            Self::InMargin => f.write_str("all in their margin"),
            Self::Nothing => f.write_str("nothing listed"),
        }
    }
}
