//! What a user may want to know.

use crate::stopwatch::PhaseTimes;

/// What a broad phase holds, and what its last update did.
///
/// An update that had nothing to look at leaves them as they are. Fields may be added in later versions; to make one, say for a
/// test, start from `Stats::default()` and set fields.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
#[non_exhaustive]
pub struct Stats {
    /// Colliders that have a box.
    pub proxies: usize,
    /// Colliders that are left out. Those whose box has a NaN or is inverted return by themselves once it is valid again. Those whose
    /// index is not less than 2²⁹ - 2¹⁶ never do, as no kernel takes so many boxes; a snapshot does not count them.
    pub refused: usize,
    /// Pairs held.
    pub pairs: usize,
    /// Pairs that the last update reported as new.
    pub added: usize,
    /// Pairs that it reported as ended.
    pub deleted: usize,
    /// Updates so far that had colliders to look at.
    pub updates: u64,
    /// Searches for all pairs so far; the other updates did without one.
    pub full_searches: u64,
    /// How long each phase of the last update took; zeros unless [`Settings::timed`](crate::Settings::timed) asks for it.
    pub times: PhaseTimes,

    /// Colliders that the last update was given, modified and removed.
    #[doc(hidden)]
    pub listed: usize,
    /// Colliders whose box it changed: they were new, had left their margin, or were refused.
    #[doc(hidden)]
    pub moved: usize,
    /// Slots in the layers above the base: their proxy is new, gone, or has left its fat box since the last full search.
    #[doc(hidden)]
    pub above_base: usize,
    /// Pairs of fat boxes that overlap: held, or soon to be.
    #[doc(hidden)]
    pub candidates: usize,
    /// How many moves ahead fat boxes reach.
    #[doc(hidden)]
    pub foresight: u32,
    /// Size classes in the last full search; 0 before the first one, and with a kernel that has none.
    #[doc(hidden)]
    pub classes: usize,
    /// What the last update took.
    #[doc(hidden)]
    pub work: Work,
}

/// The work of an update, counted in what takes time.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
#[non_exhaustive]
pub struct Work {
    /// Pairs of boxes that were compared, in the order of memory.
    pub compared: usize,
    /// Pairs of which it was asked whether one of their boxes has changed.
    pub picked: usize,
    /// Boxes whose pairs were found by their own lists.
    pub walked: usize,
    /// Boxes that were looked up among all others.
    pub looked_up: usize,
    /// Boxes that these were compared with, with what it took to find them, in comparisons.
    pub visited: usize,
    /// Boxes among which all pairs were searched for.
    pub searched: usize,
    /// Pairs that were found by either.
    pub found: usize,
}
