//! The tubes that a box spans besides its own, in each of which it is a ghost.

use super::grid::TubeSpan;

/// On this cut axis the entry is a ghost.
const GHOST: [u8; 2] = [1, 2];

/// A ghost on its way into a tube.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Ghost {
    /// Its place in the table of tubes.
    pub(super) tube: u32,
    pub(super) owner: u32,
    /// Bits of [`GHOST`].
    pub(super) axes: u8,
}

/// A box that is at most two strips wide spans at most three tubes besides its own.
pub(super) const MAX_GHOSTS: usize = 3;

/// Calls `enter` with each tube that a box spans and the axes on which it is a ghost there.
#[inline]
pub(super) fn for_each_tube(span: &TubeSpan, mut enter: impl FnMut([u32; 2], u8)) {
    let TubeSpan { first, last } = *span;
    for row in first[0]..=last[0] {
        for column in first[1]..=last[1] {
            enter([row, column], ghost_axes([row, column], first));
        }
    }
}

/// Writes the ghosts of a box that is at most two strips wide, those in the first `tube_count` tubes, to the front of
/// `list`, and returns their number. Entries past the count are unspecified.
#[inline(always)]
pub(super) fn write_ghosts<const D: usize>(
    span: &TubeSpan,
    owner: u32,
    tube_of: impl Fn([u32; 2]) -> u32,
    tube_count: u32,
    list: &mut [Ghost; MAX_GHOSTS],
) -> usize {
    let TubeSpan { first, last } = *span;
    let [is_row, is_column] = [0, 1].map(|cut| last[cut] > first[cut]);
    let mut count = 0;
    let mut write = |strips: [u32; 2], axes: u8, exists: bool| {
        let tube = tube_of(strips);
        list[count] = Ghost { tube, owner, axes };
        count += usize::from(exists & (tube < tube_count));
    };
    write([last[0], first[1]], GHOST[0], is_row);
    if D > 2 {
        write([first[0], last[1]], GHOST[1], is_column);
        write(last, GHOST[0] | GHOST[1], is_row & is_column);
    }
    count
}

/// On which cut axes a box whose `mins` lie in the tube `home` is a ghost in `tube`: bits of [`GHOST`].
#[inline(always)]
pub(super) fn ghost_axes(tube: [u32; 2], home: [u32; 2]) -> u8 {
    (GHOST[0] * u8::from(tube[0] > home[0])) | (GHOST[1] * u8::from(tube[1] > home[1]))
}
