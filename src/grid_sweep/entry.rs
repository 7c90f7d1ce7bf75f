//! Entries: a box in a tube, as its own or as a ghost.

use crate::aabb::Aabb;

/// A box on its way into the columns of a slab.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry<R, const D: usize> {
    pub(super) aabb: Aabb<R, D>,
    pub(super) owner: Owner,
}

/// An entry on its way into a tube.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Placed {
    pub(super) tube: u32,
    pub(super) owner: Owner,
}

/// A box that is at most two strips wide has entries in at most so many tubes.
pub(super) const MAX_ENTRIES: usize = 4;

/// The box that an entry belongs to: its index in the lower 30 bits, and above them the cut axes on which the entry is a ghost
/// (bit 30 for the first cut axis, bit 31 for the second). Every use needs both.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Owner(pub(super) u32);

const INDEX_BITS: u32 = 30;

impl Owner {
    /// The owner of the sentinel after each tube.
    pub(super) const NOBODY: Self = Self(u32::MAX);

    /// The owner of an entry that is a ghost on these cut axes: bit 0 for the first, bit 1 for the second.
    #[inline(always)]
    pub(super) fn new(index: u32, axes: u32) -> Self {
        Self(index | axes << INDEX_BITS)
    }

    /// The owner of the entry in the tube at `strips`, for a box whose `mins` lie in the strips `home`.
    #[inline(always)]
    pub(super) fn of(index: u32, strips: [u32; 2], home: [u32; 2]) -> Self {
        let [row, column] = [0, 1].map(|cut| u32::from(strips[cut] > home[cut]));
        Self::new(index, row | column << 1)
    }

    /// The strips of the tube that holds this entry, for a box whose `mins` lie in the strips `home`.
    #[inline(always)]
    pub(super) fn strips(self, [row, column]: [u32; 2]) -> [u32; 2] {
        let axes = self.0 >> INDEX_BITS;
        [row + (axes & 1), column + (axes >> 1)]
    }

    #[inline(always)]
    pub(super) fn index(self) -> u32 {
        self.0 & ((1 << INDEX_BITS) - 1)
    }

    /// Whether the entry is no ghost.
    #[inline(always)]
    pub(super) fn is_at_home(self) -> bool {
        self.0 >> INDEX_BITS == 0
    }

    /// Whether both entries are ghosts on the same axis.
    #[inline(always)]
    pub(super) fn shares_axis(self, other: Self) -> bool {
        (self.0 & other.0) >> INDEX_BITS != 0
    }
}
