//! A hash grid of centres: each box is in the cell of its centre, and meets those in that cell and in the cells around it.
//!
//! Cells have the median size of what can move, so that a pair is missed whose centres are further apart than its boxes allow
//! for: two that are larger than a cell. Floors and walls are compared with all others one by one. The cells are not hashed but
//! sorted: the three cells of a row are then neighbours, and each row of them is followed by an index that only grows. They are
//! sorted anew at each update, by comparison; whether hashing or another way to sort is faster has not been measured.
//! **O(n log n + candidates)**.

use super::anew::{BySize, FindAll, Proxy, extent};
use super::scenes::rapier::{math::DIM, prelude::*};
use crate::quantile::quantile;
use unisize::Aabb;

/// There are no more cells than this along an axis; what is beyond is in the last one.
const MOST_CELLS: u64 = 1 << 20;

/// Cells of one size, and what is in them.
#[derive(Default)]
pub(super) struct HashGrid {
    /// Scratch memory: all boxes, the sizes of what can move, and the boxes with the keys of their cells.
    by_size: BySize,
    sizes: Vec<Real>,
    entries: Vec<Entry>,
}

/// A box in its cell.
#[derive(Clone, Copy)]
struct Entry {
    key: u64,
    slot: u32,
    aabb: Aabb<Real, DIM>,
}

impl FindAll for HashGrid {
    fn find(&mut self, proxies: &[Option<Proxy>], pairs: &mut Vec<[u32; 2]>) {
        let mut by_size = std::mem::take(&mut self.by_size);
        by_size.part(proxies);
        by_size.find_large(pairs);
        self.find_usual(&by_size.usual, proxies, pairs);
        self.by_size = by_size;
    }
}

impl HashGrid {
    /// Finds the pairs of these boxes, which are not large.
    fn find_usual(
        &mut self,
        boxes: &[(u32, Aabb<Real, DIM>)],
        proxies: &[Option<Proxy>],
        pairs: &mut Vec<[u32; 2]>,
    ) {
        let movable = proxies.iter().flatten().filter(|proxy| proxy.can_move);
        let size =
            |proxy: &Proxy| (0..DIM).fold(0.0, |max: Real, k| max.max(extent(&proxy.aabb, k)));
        self.sizes.clear();
        self.sizes.extend(movable.map(size));
        let Some(cell) = quantile(&mut self.sizes, 0.5) else {
            return;
        };
        let strides = self.enter(boxes, cell);
        // Half of the rows around a cell, its own first; the other half finds the same pairs.
        let up = strides[1];
        let rows: &[u64] = match strides.get(2) {
            None => &[0, up],
            Some(&far) => &[0, up, far - up, far, far + up],
        };
        for &row in rows {
            self.find_in_row(row, pairs);
        }
    }

    /// Sorts the boxes into cells, and says by how much the key grows from a cell to the next one on each axis.
    fn enter(&mut self, boxes: &[(u32, Aabb<Real, DIM>)], cell: Real) -> [u64; DIM] {
        let center = |aabb: &Aabb<Real, DIM>| -> [Real; DIM] {
            std::array::from_fn(|k| (aabb.mins[k] + aabb.maxs[k]) / 2.0)
        };
        let lowest = boxes.iter().fold([Real::MAX; DIM], |low, (_, aabb)| {
            let center = center(aabb);
            std::array::from_fn(|k| low[k].min(center[k]))
        });
        // The first and the last cell along an axis stay empty, lest a row goes on in the next one.
        let cells = |aabb| -> [u64; DIM] {
            let center = center(aabb);
            std::array::from_fn(|k| {
                (((center[k] - lowest[k]) / cell) as u64).min(MOST_CELLS - 1) + 1
            })
        };
        let mut counts = [0; DIM];
        for (_, aabb) in boxes {
            let cells = cells(aabb);
            counts = std::array::from_fn(|k| counts[k].max(cells[k] + 2));
        }
        let mut strides = [1; DIM];
        for k in 1..DIM {
            strides[k] = strides[k - 1] * counts[k - 1];
        }
        self.entries.clear();
        self.entries.extend(boxes.iter().map(|(slot, aabb)| {
            let cells = cells(aabb);
            Entry {
                key: (0..DIM).map(|k| cells[k] * strides[k]).sum(),
                slot: *slot,
                aabb: *aabb,
            }
        }));
        self.entries.sort_unstable_by_key(|entry| entry.key);
        strides
    }

    /// Compares each box with those in three cells of another row, or with those behind it in its own cell and the next.
    fn find_in_row(&self, row: u64, pairs: &mut Vec<[u32; 2]>) {
        let mut start = 0;
        for (index, entry) in self.entries.iter().enumerate() {
            let middle = entry.key + row;
            if row == 0 {
                start = index + 1;
            } else {
                let before = |other: &&Entry| other.key + 1 < middle;
                start += self.entries[start..].iter().take_while(before).count();
            }
            for other in &self.entries[start..] {
                if other.key > middle + 1 {
                    break;
                }
                if entry.aabb.overlaps(&other.aabb) {
                    let [a, b] = [entry.slot, other.slot];
                    pairs.push([a.min(b), a.max(b)]);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::scenes::rapier::{math::DIM, prelude::*};
    use super::{FindAll, HashGrid, Proxy};
    use unisize::{Aabb, BruteForce, PairFinder};

    fn found(boxes: &[Aabb<Real, DIM>]) -> Vec<[u32; 2]> {
        let proxy = |(index, &aabb): (usize, _)| {
            Some(Proxy {
                handle: ColliderHandle::from_raw_parts(index as u32, 0),
                can_move: true,
                aabb,
            })
        };
        let proxies: Vec<_> = boxes.iter().enumerate().map(proxy).collect();
        let mut pairs = Vec::new();
        HashGrid::default().find(&proxies, &mut pairs);
        pairs.sort_unstable();
        pairs
    }

    fn expected(boxes: &[Aabb<Real, DIM>]) -> Vec<[u32; 2]> {
        let mut pairs = Vec::new();
        BruteForce
            .find_pairs(boxes, &mut pairs)
            .expect("the boxes are valid");
        pairs.sort_unstable();
        pairs
    }

    /// Boxes of this size at random places of a cube, in multiples of 1/64, so that all sizes are exact.
    fn boxes(count: usize, room: u32, size: Real, seed: u64) -> Vec<Aabb<Real, DIM>> {
        let mut random = oorandom::Rand32::new(seed);
        let mut place = || random.rand_range(0..64 * room) as Real / 64.0 - room as Real / 2.0;
        let mut aabb = || {
            let mins: [Real; DIM] = std::array::from_fn(|_| place());
            Aabb::new(mins, mins.map(|x| x + size))
        };
        (0..count).map(|_| aabb()).collect()
    }

    #[test]
    fn boxes_no_larger_than_a_cell_are_all_found() {
        for (seed, room) in (0..).zip([2, 8, 30, 1000]) {
            let mut boxes = boxes(400, room, 1.0, seed);
            // Fewer than half are smaller, so that the median is still 1.
            for aabb in boxes.iter_mut().step_by(3) {
                aabb.maxs = aabb.mins.map(|x| x + 0.25);
            }
            let pairs = found(&boxes);
            assert_eq!(pairs, expected(&boxes), "in {room}");
        }
    }

    #[test]
    fn boxes_larger_than_two_cells_are_missed() {
        let mut boxes = boxes(9, 1000, 1.0, 3);
        boxes.push(Aabb::new([0.0; DIM], [5.0; DIM]));
        boxes.push(Aabb::new([4.5; DIM], [9.5; DIM]));
        let pairs = expected(&boxes);
        assert!(pairs.contains(&[9, 10]));
        assert!(!found(&boxes).contains(&[9, 10]));
    }

    #[test]
    fn there_may_be_nothing() {
        assert!(found(&[]).is_empty());
        assert!(found(&boxes(1, 1, 1.0, 1)).is_empty());
    }
}
