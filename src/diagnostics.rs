//! What tests and studies read beyond the [statistics](crate::Stats), and what they fix.

/// The state of the search for pairs. No event depends on it, and it is not saved.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Diagnostics {
    /// Pairs of fat boxes that overlap.
    pub candidates: usize,
    /// How many moves ahead fat boxes reach.
    pub foresight: u16,
}

/// Replaces choices that the tracker makes for itself. They affect speed and memory, never events. Neither settings nor snapshots
/// contain them.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Overrides {
    /// How many moves ahead fat boxes reach, in place of a number that follows from the speed. A number that is too large for the
    /// scene costs time and memory.
    pub foresight: Option<u16>,
    /// Every search is a full search: colliders that have left their fat boxes are not looked up among the others.
    pub full_searches_only: bool,
}
