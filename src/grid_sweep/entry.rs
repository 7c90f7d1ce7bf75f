//! Entries: a box in a tube, as its own or as a ghost.

use crate::aabb::Aabb;

/// A box on its way into a tube.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry<R, const D: usize> {
    pub(super) aabb: Aabb<R, D>,
    pub(super) owner: Owner,
}

/// The box that an entry belongs to: its index in the lower 30 bits, and above them the cut axes on which the entry is a ghost
/// (bit 30 for the first cut axis, bit 31 for the second). Every use needs both.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Owner(pub(super) u32);

const INDEX_BITS: u32 = 30;

/// The bit of a ghost on each cut axis.
const GHOST: [u32; 2] = [1 << INDEX_BITS, 2 << INDEX_BITS];

impl Owner {
    /// The owner of the sentinel after each tube.
    pub(super) const NOBODY: Self = Self(u32::MAX);

    /// The owner of the entry in the tube at `strips`, for a box whose `mins` lie in the strips `home`.
    #[inline(always)]
    pub(super) fn of(index: u32, strips: [u32; 2], home: [u32; 2]) -> Self {
        let [row, column] = [0, 1].map(|cut| GHOST[cut] * u32::from(strips[cut] > home[cut]));
        Self(index | row | column)
    }

    /// The strips of the tube that holds this entry, for a box whose `mins` lie in the strips `home`.
    #[inline(always)]
    pub(super) fn strips(self, home: [u32; 2]) -> [u32; 2] {
        [0, 1].map(|cut| home[cut] + u32::from(self.0 & GHOST[cut] != 0))
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

/// A ghost on its way into a tube.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Ghost {
    pub(super) tube: u32,
    pub(super) owner: Owner,
}

/// A box that is at most two strips wide has entries in at most three tubes besides its own.
pub(super) const MAX_GHOSTS: usize = 3;

impl Ghost {
    /// Writes the ghosts of a box to the front of `list` and returns their number. Entries past that number are unspecified.
    ///
    /// The arguments are the next tube along each cut axis and along both, and whether the box reaches the next strip on each
    /// cut axis (1) or not (0).
    #[inline(always)]
    pub(super) fn write_all<const D: usize>(
        index: u32,
        [next_row, next_column, next_both]: [u32; 3],
        [is_row, is_column]: [u32; 2],
        list: &mut [Self; MAX_GHOSTS],
    ) -> usize {
        let mut count = 0;
        let mut write = |tube: u32, axes: u32, exists: u32| {
            let owner = Owner(index | axes);
            list[count] = Self { tube, owner };
            count += exists as usize;
        };
        write(next_row, GHOST[0], is_row);
        if D > 2 {
            write(next_column, GHOST[1], is_column);
            write(next_both, GHOST[0] | GHOST[1], is_row & is_column);
        }
        count
    }
}
