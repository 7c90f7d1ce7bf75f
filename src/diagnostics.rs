//! Numbers for tests and studies, beyond the [statistics](crate::Stats).

/// The state of the search for pairs, and counts of the last update. No event depends on them, and they are not saved.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Diagnostics {
    /// Colliders that the last update was passed, modified and removed.
    pub listed: usize,
    /// Colliders whose box it changed: new ones, those that had left their margin, and refused ones.
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
