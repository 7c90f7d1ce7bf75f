//! The sweep: windows over sorted entries, eight at a time.

use super::tubes::Tubes;
use crate::lanes::{LANES, Lanes};
use crate::pair_finder::ordered;
use crate::{Aabb, Real};

/// For each byte, the positions of the bits that are set, three bits each, the lowest first; from bit 24 on, how many
/// there are. Not every processor can be relied on to count bits, and searching for them one by one takes more steps.
const ONES: [u32; 1 << LANES] = {
    let mut ones = [0; 1 << LANES];
    let mut bits = 0;
    while bits < ones.len() {
        let (mut position, mut count) = (0, 0);
        while position < LANES {
            if bits >> position & 1 == 1 {
                ones[bits] |= (position as u32) << (3 * count);
                count += 1;
            }
            position += 1;
        }
        ones[bits] |= count << 24;
        bits += 1;
    }
    ones
};

/// How many pairs are collected before they are appended to the output.
const BUFFER: usize = 512;

/// Pairs on their way to the output.
///
/// Most boxes have a few candidates, and how many of them are hits is practically random; a branch on that would be
/// mispredicted for every other box. So a fixed number of pairs is always written, and the cursor moves on by the
/// number of hits.
pub(super) struct Emitter<'a> {
    pairs: &'a mut Vec<[u32; 2]>,
    buffer: [[u32; 2]; BUFFER],
    len: usize,
}

impl<'a> Emitter<'a> {
    pub(super) fn new(pairs: &'a mut Vec<[u32; 2]>) -> Self {
        Self {
            pairs,
            buffer: [[0; 2]; BUFFER],
            len: 0,
        }
    }

    /// Appends the pairs of `owner` with those of eight others whose bit in `hits` is set.
    #[inline(always)]
    fn emit(&mut self, owner: u32, others: &[u32; LANES], hits: u32) {
        if self.len > BUFFER - LANES {
            self.flush();
        }
        let mut ones = ONES[hits as usize % ONES.len()];
        let count = (ones >> 24) as usize;
        let written = &mut self.buffer[self.len..self.len + LANES];
        for pair in &mut written[..2] {
            *pair = ordered(owner, others[ones as usize % LANES]);
            ones >>= 3;
        }
        if count > 2 {
            for pair in &mut written[2..count] {
                *pair = ordered(owner, others[ones as usize % LANES]);
                ones >>= 3;
            }
        }
        self.len += count;
    }

    fn flush(&mut self) {
        self.pairs.extend_from_slice(&self.buffer[..self.len]);
        self.len = 0;
    }

    /// Appends what is left.
    pub(super) fn finish(mut self) {
        self.flush();
    }
}

/// The columns of the entries, all of one length, so that one bounds check is enough for all of them.
#[derive(Clone, Copy)]
pub(super) struct Columns<'a, R, const D: usize> {
    mins: [&'a [R]; D],
    maxs: [&'a [R]; D],
    owners: &'a [u32],
    ghosts: &'a [u8],
}

impl<R: Real, const D: usize> Tubes<R, D> {
    #[inline(always)]
    pub(super) fn columns(&self) -> Columns<'_, R, D> {
        let n = self.owners.len();
        Columns {
            mins: core::array::from_fn(|k| &self.mins[k][..n]),
            maxs: core::array::from_fn(|k| &self.maxs[k][..n]),
            owners: &self.owners[..n],
            ghosts: &self.ghosts[..n],
        }
    }

    /// Reports every overlapping pair among the entries of each tube, except those of two ghosts on the same axis,
    /// which another tube reports.
    pub(super) fn sweep(&self, emitter: &mut Emitter) {
        let columns = self.columns();
        for tube in &self.tubes {
            for i in tube.start as usize..tube.end as usize {
                let aabb = Aabb {
                    mins: core::array::from_fn(|k| columns.mins[k][i]),
                    maxs: core::array::from_fn(|k| columns.maxs[k][i]),
                };
                // Entries from i on have mins[0] no less than this one's, so only their mins[0] is compared.
                columns.window::<false>(
                    i + 1,
                    &aabb,
                    columns.owners[i],
                    columns.ghosts[i],
                    emitter,
                );
            }
        }
    }
}

impl<R: Real, const D: usize> Columns<'_, R, D> {
    /// Reports every entry from `start` on that overlaps the box, up to the first whose `mins[0]` lies
    /// beyond it.
    #[inline(always)]
    pub(super) fn window<const BOTH_SIDES: bool>(
        self,
        start: usize,
        aabb: &Aabb<R, D>,
        owner: u32,
        ghost: u8,
        emitter: &mut Emitter,
    ) {
        let mins = aabb.mins.map(R::Lanes::splat);
        let maxs = aabb.maxs.map(R::Lanes::splat);
        let mut j = start;
        // After the last tube there are a sentinel and eight lanes of padding.
        while j <= self.owners.len().saturating_sub(LANES) {
            let reached = load::<R>(self.mins[0], j).le(maxs[0]);
            let mut overlap = reached;
            if BOTH_SIDES {
                overlap = overlap & load::<R>(self.maxs[0], j).ge(mins[0]);
            }
            for k in 1..D {
                overlap = overlap
                    & load::<R>(self.mins[k], j).le(maxs[k])
                    & load::<R>(self.maxs[k], j).ge(mins[k]);
            }
            let reached = reached.bits();
            // The lanes before the first that is not reached.
            let in_window = (reached ^ (reached + 1)) >> 1;
            let mut hits = overlap.bits() & in_window;
            hits &= !shared_axes(ghost, eight(self.ghosts, j));
            emitter.emit(owner, eight(self.owners, j), hits);
            if reached != (1 << LANES) - 1 {
                return;
            }
            j += LANES;
        }
    }
}

/// The eight numbers from `start` on.
#[inline(always)]
fn load<R: Real>(numbers: &[R], start: usize) -> R::Lanes {
    R::Lanes::load(eight(numbers, start))
}

#[inline(always)]
fn eight<T>(items: &[T], start: usize) -> &[T; LANES] {
    items[start..]
        .first_chunk()
        .expect("the columns are padded")
}

/// In which of eight lanes the entry is a ghost on an axis on which `ghost` is one too.
#[inline(always)]
fn shared_axes(ghost: u8, lanes: &[u8; LANES]) -> u32 {
    const EACH: u64 = 0x0101_0101_0101_0101;
    let shared = u64::from_le_bytes(*lanes) & (u64::from(ghost) * EACH);
    // One bit per byte; then a multiplication shifts each to its place, one bit per lane.
    let any = (shared | shared >> 1) & EACH;
    (any.wrapping_mul(0x0102_0408_1020_4080) >> 56) as u32
}
