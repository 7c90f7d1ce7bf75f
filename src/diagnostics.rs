//! What tests and studies read beyond the [statistics](crate::Stats), and what they fix.

/// The state of the search for pairs, and counts of the last update. No event depends on them, and they are not saved.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Diagnostics {
    /// Colliders that the last update was passed, modified and removed.
    pub listed: usize,
    /// Boxes of known colliders that it changed: of new ones, of those that had left their margin, and of refused ones. A collider that was
    /// passed twice may count twice.
    pub moved: usize,
    /// Slots in the layers above the base: their proxy is new, is gone, or has left its fat box since the last full search.
    pub above_base: usize,
    /// Pairs of fat boxes that overlap.
    pub candidates: usize,
    /// How many moves ahead fat boxes reach.
    pub foresight: u16,
    /// Size classes in the last full search; 0 before the first one, and where each box is compared with each.
    pub classes: usize,
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
