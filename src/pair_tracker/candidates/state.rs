//! What is known of a candidate.

/// Whether a candidate is a pair. By a byte, so that many are asked at once.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::pair_tracker) enum PairState {
    /// Its boxes do not overlap.
    #[default]
    Apart,
    /// Its boxes overlap, but it is not held, because its volumes have not met yet, or no longer do.
    Near,
    /// It is held.
    Held,
}

impl PairState {
    #[inline(always)]
    pub(super) fn is_held(self) -> bool {
        self == Self::Held
    }
}
