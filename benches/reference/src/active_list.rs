//! The active list: the boxes that the sweep line crosses.
//!
//! A box enters at its low endpoint. At its high endpoint it leaves, and is then tested against all that remain. The
//! list is dense, in blocks of eight boxes that hold each side of the eight contiguously, so that the compiler tests eight
//! boxes at once. It knows the place of each box, so a box is removed by moving the last one into its place.

use crate::ordered;
use unisize::{Aabb, Real};

/// How many boxes a block has.
const LANES: usize = 8;

/// The boxes of this many endpoints are fetched before these endpoints are swept. The boxes are scattered in memory, and
/// fetching a batch takes little longer than fetching one.
const BATCH: usize = 32;

/// The boxes that the sweep line crosses. All of it is scratch memory.
#[derive(Clone, Debug, Default)]
pub(crate) struct ActiveList<R, const D: usize> {
    /// As many as were ever needed. Lanes past the last box hold NaN, which overlaps nothing.
    blocks: Vec<Block<R, D>>,
    /// How many boxes are in the list.
    len: usize,
    /// By object: its place in the list, if it is there.
    places: Vec<u32>,
}

/// Eight boxes.
#[derive(Clone, Debug)]
struct Block<R, const D: usize> {
    mins: [[R; LANES]; D],
    maxs: [[R; LANES]; D],
    owners: [u32; LANES],
}

impl<R: Real, const D: usize> Block<R, D> {
    fn empty() -> Self {
        let nan = [[R::from_f64(f64::NAN); LANES]; D];
        Self {
            mins: nan,
            maxs: nan,
            owners: [0; LANES],
        }
    }

    #[inline]
    fn get(&self, lane: usize) -> Aabb<R, D> {
        Aabb {
            mins: core::array::from_fn(|k| self.mins[k][lane]),
            maxs: core::array::from_fn(|k| self.maxs[k][lane]),
        }
    }

    #[inline]
    fn set(&mut self, lane: usize, owner: u32, aabb: &Aabb<R, D>) {
        self.owners[lane] = owner;
        for k in 0..D {
            self.mins[k][lane] = aabb.mins[k];
            self.maxs[k][lane] = aabb.maxs[k];
        }
    }

    /// One byte a lane, the first the lowest: 1 where the boxes overlap on these axes, else 0.
    #[inline]
    fn overlaps(&self, aabb: &Aabb<R, D>, axes: core::ops::Range<usize>) -> u64 {
        let mut overlaps = [1_u8; LANES];
        for k in axes {
            for lane in 0..LANES {
                let overlap =
                    (self.mins[k][lane] <= aabb.maxs[k]) & (self.maxs[k][lane] >= aabb.mins[k]);
                overlaps[lane] &= u8::from(overlap);
            }
        }
        u64::from_le_bytes(overlaps)
    }
}

impl<R: Real, const D: usize> ActiveList<R, D> {
    /// The first axis that is tested. Axis 0 is swept, so it is tested only if there is no other.
    const FIRST_TESTED: usize = if D > 1 { 1 } else { 0 };

    /// Sweeps the endpoints of the first axis, `i` for lows and `i + n` for highs, and appends every overlapping pair.
    ///
    /// Computes in **O(n k)** time, where k is how many boxes overlap at once on the first axis.
    pub(crate) fn sweep(
        &mut self,
        mut endpoints: impl Iterator<Item = u32>,
        boxes: &[Aabb<R, D>],
        pairs: &mut Vec<[u32; 2]>,
    ) {
        let n = boxes.len() as u32;
        self.places.resize(boxes.len(), 0);
        let mut batch = [(0, Aabb::new([R::default(); D], [R::default(); D])); BATCH];
        loop {
            let mut count = 0;
            for (fetched, endpoint) in batch.iter_mut().zip(&mut endpoints) {
                let owner = if endpoint < n { endpoint } else { endpoint - n };
                *fetched = (endpoint, boxes[owner as usize]);
                count += 1;
            }
            for (endpoint, aabb) in &batch[..count] {
                if *endpoint < n {
                    self.enter(*endpoint, aabb);
                } else {
                    self.leave(endpoint - n);
                    self.test(endpoint - n, aabb, pairs);
                }
            }
            if count < BATCH {
                return;
            }
        }
    }

    #[inline]
    fn enter(&mut self, owner: u32, aabb: &Aabb<R, D>) {
        let (block, lane) = (self.len / LANES, self.len % LANES);
        if block == self.blocks.len() {
            self.blocks.push(Block::empty());
        }
        self.blocks[block].set(lane, owner, aabb);
        self.places[owner as usize] = self.len as u32;
        self.len += 1;
    }

    #[inline]
    fn leave(&mut self, owner: u32) {
        self.len -= 1;
        let last = &mut self.blocks[self.len / LANES];
        let lane = self.len % LANES;
        let (moved_owner, moved) = (last.owners[lane], last.get(lane));
        let nan = [R::from_f64(f64::NAN); D];
        last.set(lane, moved_owner, &Aabb::new(nan, nan));
        if moved_owner != owner {
            let place = self.places[owner as usize];
            self.places[moved_owner as usize] = place;
            let (block, lane) = (place as usize / LANES, place as usize % LANES);
            self.blocks[block].set(lane, moved_owner, &moved);
        }
    }

    /// Appends the pairs of a box with those in the list that it overlaps.
    #[inline]
    fn test(&self, owner: u32, aabb: &Aabb<R, D>, pairs: &mut Vec<[u32; 2]>) {
        for block in &self.blocks[..self.len.div_ceil(LANES)] {
            let mut hits = block.overlaps(aabb, Self::FIRST_TESTED..D);
            while hits != 0 {
                let other = block.owners[hits.trailing_zeros() as usize / 8];
                pairs.push(ordered(owner, other));
                hits &= hits - 1;
            }
        }
    }
}
