//! The tubes that a box spans besides its own, in each of which it is a ghost.

use super::grid::TubeSpan;
use super::owner::Owner;

/// On this cut axis the entry is a ghost: bits of [`Owner::ghost`].
const AXES: [u32; 2] = [1, 2];

/// A ghost on its way into a tube.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Ghost {
    pub(super) tube: u32,
    pub(super) owner: Owner,
}

/// A box that is at most two strips wide spans at most three tubes besides its own.
pub(super) const MAX_GHOSTS: usize = 3;

/// Calls `enter` with each tube that a box spans, and whose the entry there is.
#[inline]
pub(super) fn for_each_tube(span: &TubeSpan, index: u32, mut enter: impl FnMut([u32; 2], Owner)) {
    let TubeSpan { first, last } = *span;
    for row in first[0]..=last[0] {
        for column in first[1]..=last[1] {
            enter([row, column], owner_in([row, column], first, index));
        }
    }
}

/// Writes the ghosts of a box that is at most two strips wide to the front of `list`, and returns their number. Entries
/// past the count are unspecified. The box is in the tube of number `home`, `columns` of which are in a row, and goes on into
/// the next tube on each of the cut axes where `beyond` is one.
#[inline(always)]
pub(super) fn write_ghosts<const D: usize>(
    index: u32,
    home: u32,
    columns: u32,
    beyond: [u32; 2],
    list: &mut [Ghost; MAX_GHOSTS],
) -> usize {
    let mut count = 0;
    let mut write = |tube: u32, axes: u32, exists: u32| {
        list[count] = Ghost {
            tube,
            owner: Owner::ghost(index, axes),
        };
        count += exists as usize;
    };
    let [is_row, is_column] = beyond;
    write(home + columns, AXES[0], is_row);
    if D > 2 {
        write(home + 1, AXES[1], is_column);
        write(home + columns + 1, AXES[0] | AXES[1], is_row & is_column);
    }
    count
}

/// The owner of the entry in `tube` of a box whose `mins` lie in the tube `home`.
#[inline(always)]
pub(super) fn owner_in(tube: [u32; 2], home: [u32; 2], index: u32) -> Owner {
    let axes = [0, 1].map(|cut| AXES[cut] * u32::from(tube[cut] > home[cut]));
    Owner::ghost(index, axes[0] | axes[1])
}
