//! What happens to colliders between two updates: alike for every engine and dimension.

/// Which colliders are listed, and how they have moved.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Motion {
    /// One collider in this many drifts on, and only those are listed.
    OneIn(usize),
    /// All are listed, and none has left the margin around its box.
    InMargin,
}

impl Motion {
    pub(crate) fn name(self) -> String {
        match self {
            Self::OneIn(1) => "all move".to_owned(),
            Self::OneIn(stride) => format!("one in {stride} moves"),
            Self::InMargin => "all in their margin".to_owned(),
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

/// Cubes of side 1 and their motion. Equal cases make equal frames.
#[derive(Clone, Copy)]
pub(crate) struct Case {
    pub(crate) count: usize,
    /// The part of the area or volume that they would fill if they did not overlap.
    pub(crate) density: f64,
    pub(crate) motion: Motion,
    /// Whether each is on a dynamic body, or has none.
    pub(crate) bodies: bool,
}
