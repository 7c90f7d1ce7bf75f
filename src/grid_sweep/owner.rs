//! Whose an entry is, and whether it is a ghost there.

/// The index of the box of an entry, in the lower bits, and above them the cut axes on which the entry is a ghost.
///
/// In one number, because they are always wanted together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Owner(u32);

/// The bits of the index.
const INDEX_BITS: u32 = 30;

impl Owner {
    /// Beyond the last entry of a tube.
    pub(super) const NOBODY: Self = Self(u32::MAX);

    /// The owner of an entry in its own tube.
    #[inline(always)]
    pub(super) fn at_home(index: u32) -> Self {
        Self(index)
    }

    /// The owner of a ghost, or of an entry at home if it is one on no axis. On the cut axis `k` it is one if bit `k` of `axes`
    /// is set.
    #[inline(always)]
    pub(super) fn ghost(index: u32, axes: u32) -> Self {
        Self(index | axes << INDEX_BITS)
    }

    /// The owner of these [`bits`](Self::bits).
    #[inline(always)]
    pub(super) fn from_bits(bits: u32) -> Self {
        Self(bits)
    }

    #[inline(always)]
    pub(super) fn bits(self) -> u32 {
        self.0
    }

    #[inline(always)]
    pub(super) fn index(self) -> u32 {
        self.0 & ((1 << INDEX_BITS) - 1)
    }

    #[inline(always)]
    pub(super) fn is_at_home(self) -> bool {
        self.0 >> INDEX_BITS == 0
    }

    /// Whether both are ghosts on the same axis.
    #[inline(always)]
    pub(super) fn shares_axis(self, other: Self) -> bool {
        (self.0 & other.0) >> INDEX_BITS != 0
    }
}
