//! What happens to the colliders between two updates.

/// Which colliders are listed, and how they have moved.
#[derive(Clone, Copy)]
pub(crate) enum Motion {
    /// One collider in this many drifts on, and only those are listed.
    OneIn(usize),
    /// All are listed, and none has left the margin around its box.
    InMargin,
}

impl Motion {
    pub(crate) const ALL: [Self; 4] = [
        Self::OneIn(1),
        Self::OneIn(10),
        Self::OneIn(100),
        Self::InMargin,
    ];

    pub(crate) fn name(self) -> String {
        match self {
            Self::OneIn(1) => "all-move".to_owned(),
            Self::OneIn(stride) => format!("one-in-{stride}-moves"),
            Self::InMargin => "all-in-margin".to_owned(),
        }
    }

    /// The distance, in indices, from one listed collider to the next.
    pub(crate) fn stride(self) -> usize {
        match self {
            Self::OneIn(stride) => stride,
            Self::InMargin => 1,
        }
    }
}
