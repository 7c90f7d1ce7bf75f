//! What a user may want to know.

use crate::PhaseTimes;

/// A look at a broad phase: what it holds, and what the last update with something to do was made of.
///
/// Counters may be added in later versions; to make one, say for a test, start from `Stats::default()` and set fields.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
#[non_exhaustive]
pub struct Stats {
    /// Colliders that have a proxy.
    pub proxies: usize,
    /// Colliders that are left out because their box has a NaN or is inverted. They return by themselves once it is
    /// valid again.
    pub refused: usize,
    /// Slots whose proxy is new, gone, or has moved otherwise than foreseen since the last full run of the kernel: they are
    /// in the layers above the base.
    pub above_base: usize,
    /// Pairs held.
    pub pairs: usize,
    /// Pairs that are watched, because they are held or may soon be.
    pub candidates: usize,
    /// How far ahead colliders are searched for, in multiples of their last move; 0 where things are too fast.
    pub foresight: u32,
    /// Searches for all pairs so far; the other updates did without one.
    pub full_runs: u64,
    /// Size classes in the last of these searches: 1 where sizes agree; 0 before the first one, and with a kernel that
    /// has none.
    pub classes: usize,
    /// The number of strips into which the first size class is cut, along the second and the third axis. A planar scene
    /// is not cut across its plane.
    pub strips: [u32; 2],
    /// Updates so far that had colliders to look at.
    pub updates: u64,
    /// Colliders that the last such update was given, modified and removed.
    pub listed: usize,
    /// Colliders whose box that update changed: they were new, had left their margin, or were refused.
    pub moved: usize,
    /// What the update took.
    pub work: Work,
    /// Pairs that it reported as new.
    pub added: usize,
    /// Pairs that it reported as ended.
    pub deleted: usize,
    /// How long each phase of that update took; zeros unless [`Settings::timed`](crate::Settings::timed) asks for it.
    pub times: PhaseTimes,
}

/// The work of an update, counted in what takes time. How far ahead colliders are searched for is decided by it.
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
    /// Boxes among which all pairs were searched for.
    pub searched: usize,
    /// Pairs that were found by either.
    pub found: usize,
}
