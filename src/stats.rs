//! What a broad phase tells its user.

/// What a broad phase holds, and what its last update did.
///
/// An update with nothing to do leaves them as they are. Later versions may add fields; to make a value, say for a test, start from
/// `Stats::default()` and set fields.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
#[non_exhaustive]
pub struct Stats {
    /// Colliders with a box.
    pub proxies: usize,
    /// Colliders that are left out. A collider returns by itself once its box is valid, if its box was inverted or had a NaN; and once its box
    /// is finite, if its first box in a pipeline of 0.36 was infinite. A collider whose index is 2²⁹ - 2¹⁶ or more never returns, because
    /// `GridSweep` takes no more boxes; a loaded broad phase does not count these.
    pub refused: usize,
    /// Pairs held.
    pub pairs: usize,
    /// Pairs that the last update reported as new.
    pub added: usize,
    /// Pairs that the last update reported as ended.
    pub deleted: usize,
    /// Updates so far with something to do.
    pub updates: u64,
    /// Searches for all pairs so far. The other updates needed none.
    pub full_searches: u64,
}
