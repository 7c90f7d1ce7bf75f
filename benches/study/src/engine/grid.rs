//! A hash grid of centres: each box is in the cell of its centre, and is compared with the boxes in that cell and in the adjacent cells.
//!
//! Cells have the largest or the median size of the colliders that can move. With the median, the grid misses pairs of boxes that are
//! larger than a cell. Floors and walls, which are larger than every collider that can move, are compared with all boxes. The cells are
//! sorted instead of hashed: then the three cells of a row are neighbours, and an index that only grows follows each row.
//!
//! Each update searches for all pairs, and compares them with the held ones: **O(n log n + candidates)**.

use super::scenes::rapier::{math::DIM, prelude::*};
use crate::finder::Cell;
use unisize::Aabb;

/// The largest number of cells along an axis; boxes beyond are in the last one.
const MOST_CELLS: u64 = 1 << 20;

/// Cells of one size, and their colliders.
pub(super) struct HashGrid {
    cell: Cell,
    /// By the index of the collider's handle.
    proxies: Vec<Option<Proxy>>,
    /// The pairs held, as sorted keys.
    held: Vec<u64>,
}

/// A collider that a broad phase knows.
#[derive(Clone, Copy)]
struct Proxy {
    handle: ColliderHandle,
    can_move: bool,
    aabb: Aabb<Real, DIM>,
}

/// A box in its cell.
struct Entry {
    key: u64,
    slot: u32,
    aabb: Aabb<Real, DIM>,
}

impl HashGrid {
    /// An empty grid with cells of this size.
    pub(super) fn new(cell: Cell) -> Self {
        Self {
            cell,
            proxies: Vec::new(),
            held: Vec::new(),
        }
    }

    fn place(&mut self, handle: ColliderHandle, proxy: Option<Proxy>) {
        let slot = handle.into_raw_parts().0 as usize;
        if self.proxies.len() <= slot {
            self.proxies.resize(slot + 1, None);
        }
        self.proxies[slot] = proxy;
    }

    /// Reports how the sorted pairs found differ from those held, and holds them.
    fn replace(&mut self, found: Vec<u64>, events: &mut Vec<BroadPhasePairEvent>) {
        let handle = |slot: u32| {
            let proxy = self.proxies[slot as usize];
            proxy
                .expect("the colliders of a held pair are known")
                .handle
        };
        let pair = |key: u64| ColliderPair::new(handle((key >> 32) as u32), handle(key as u32));
        let mut before = self.held.iter().copied().peekable();
        for &key in &found {
            while let Some(gone) = before.next_if(|&other| other < key) {
                events.push(BroadPhasePairEvent::DeletePair(pair(gone)));
            }
            if before.next_if_eq(&key).is_none() {
                events.push(BroadPhasePairEvent::AddPair(pair(key)));
            }
        }
        events.extend(before.map(|gone| BroadPhasePairEvent::DeletePair(pair(gone))));
        self.held = found;
    }

    /// All pairs as keys, the smaller index first, in no order.
    fn find(&self) -> Vec<u64> {
        let known = || {
            let slots = (0..).zip(&self.proxies);
            slots.filter_map(|(slot, proxy)| Some((slot, proxy.as_ref()?)))
        };
        let movable = known().filter(|(_, proxy)| proxy.can_move);
        let movable: Vec<_> = movable.map(|(_, proxy)| extents(&proxy.aabb)).collect();
        let largest = movable
            .iter()
            .fold([0.0; DIM], |size: [Real; DIM], extents| {
                std::array::from_fn(|k| size[k].max(extents[k]))
            });
        // The boxes that are larger on some axis than all that can move, and the others.
        let boxes = known().map(|(slot, proxy)| (slot, proxy.aabb));
        let (usual, large): (Vec<_>, Vec<_>) = boxes.partition(|(_, aabb)| {
            let extents = extents(aabb);
            (0..DIM).all(|k| extents[k] <= largest[k])
        });
        let mut found = Vec::new();
        for (index, &(slot, aabb)) in large.iter().enumerate() {
            let others = usual.iter().chain(&large[..index]);
            let others = others.filter(|(_, other)| aabb.intersects(other));
            found.extend(others.map(|&(other, _)| key(slot, other)));
        }
        let size = |extents: &[Real; DIM]| extents.iter().copied().fold(0.0, Real::max);
        let mut sizes: Vec<_> = movable.iter().map(size).collect();
        sizes.sort_by(Real::total_cmp);
        let cell = match self.cell {
            Cell::Largest => sizes.last(),
            Cell::Median => sizes.get(sizes.len() / 2),
        };
        if let Some(&cell) = cell {
            let (entries, strides) = enter(&usual, cell);
            // Half of the rows around a cell, its own first; the other half finds the same pairs.
            let up = strides[1];
            let rows: &[u64] = match strides.get(2) {
                None => &[0, up],
                Some(&far) => &[0, up, far - up, far, far + up],
            };
            for &row in rows {
                find_in_row(&entries, row, &mut found);
            }
        }
        found
    }
}

/// Sorts boxes into cells, and says by how much the key grows from a cell to the next one on each axis.
fn enter(boxes: &[(u32, Aabb<Real, DIM>)], cell: Real) -> (Vec<Entry>, [u64; DIM]) {
    let center = |aabb: &Aabb<Real, DIM>| -> [Real; DIM] {
        std::array::from_fn(|k| (aabb.mins[k] + aabb.maxs[k]) / 2.0)
    };
    let lowest = boxes.iter().fold([Real::MAX; DIM], |low, (_, aabb)| {
        let center = center(aabb);
        std::array::from_fn(|k| low[k].min(center[k]))
    });
    // The first and the last cell along an axis stay empty, so that no row continues in the next one.
    let cells = |aabb: &Aabb<Real, DIM>| -> [u64; DIM] {
        let center = center(aabb);
        std::array::from_fn(|k| (((center[k] - lowest[k]) / cell) as u64).min(MOST_CELLS - 1) + 1)
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
    let entry = |&(slot, aabb): &(u32, Aabb<Real, DIM>)| {
        let cells = cells(&aabb);
        let key = (0..DIM).map(|k| cells[k] * strides[k]).sum();
        Entry { key, slot, aabb }
    };
    let mut entries: Vec<_> = boxes.iter().map(entry).collect();
    entries.sort_unstable_by_key(|entry| entry.key);
    (entries, strides)
}

/// Compares each box with the boxes in three cells of another row, or with the boxes after it in its own cell and the next.
fn find_in_row(entries: &[Entry], row: u64, found: &mut Vec<u64>) {
    let mut start = 0;
    for (index, entry) in entries.iter().enumerate() {
        let middle = entry.key + row;
        if row == 0 {
            start = index + 1;
        } else {
            let before = |other: &&Entry| other.key + 1 < middle;
            start += entries[start..].iter().take_while(before).count();
        }
        let near = entries[start..].iter();
        let near = near.take_while(|other| other.key <= middle + 1);
        let near = near.filter(|other| entry.aabb.intersects(&other.aabb));
        found.extend(near.map(|other| key(entry.slot, other.slot)));
    }
}

/// The key of a pair.
fn key(a: u32, b: u32) -> u64 {
    u64::from(a.min(b)) << 32 | u64::from(a.max(b))
}

fn extents(aabb: &Aabb<Real, DIM>) -> [Real; DIM] {
    std::array::from_fn(|k| aabb.maxs[k] - aabb.mins[k])
}

impl BroadPhase for HashGrid {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        if modified.is_empty() && removed.is_empty() {
            return;
        }
        for &handle in removed {
            self.place(handle, None);
            let slot = handle.into_raw_parts().0;
            let has = |key: u64| (key >> 32) as u32 == slot || key as u32 == slot;
            self.held.retain(|&key| !has(key));
        }
        for &handle in modified {
            let Some(collider) = colliders.get(handle) else {
                continue;
            };
            let aabb = collider.compute_collision_aabb(params.prediction_distance() / 2.0);
            let body = collider.parent().map(|parent| &bodies[parent]);
            let proxy = Proxy {
                handle,
                can_move: body.is_some_and(|body| !body.is_fixed()),
                aabb: Aabb::new(aabb.mins.coords.into(), aabb.maxs.coords.into()),
            };
            self.place(handle, Some(proxy));
        }
        let mut found = self.find();
        found.sort_unstable();
        self.replace(found, events);
    }
}

#[cfg(test)]
mod tests {
    use super::super::scenes::rapier::{math::DIM, prelude::*};
    use super::{Cell, HashGrid, Proxy};
    use unisize::{Aabb, BruteForce, PairFinder};

    fn found(cell: Cell, boxes: &[Aabb<Real, DIM>]) -> Vec<[u32; 2]> {
        let proxy = |(index, &aabb): (usize, _)| {
            Some(Proxy {
                handle: ColliderHandle::from_raw_parts(index as u32, 0),
                can_move: true,
                aabb,
            })
        };
        let mut grid = HashGrid::new(cell);
        grid.proxies = boxes.iter().enumerate().map(proxy).collect();
        let mut found = grid.find();
        found.sort_unstable();
        let pair = |key: u64| [(key >> 32) as u32, key as u32];
        found.into_iter().map(pair).collect()
    }

    fn expected(boxes: &[Aabb<Real, DIM>]) -> Vec<[u32; 2]> {
        let mut pairs = Vec::new();
        BruteForce
            .find_pairs(boxes, &mut pairs)
            .expect("the boxes are valid");
        pairs.sort_unstable();
        pairs
    }

    /// Boxes of size 1 at random places of a cube, in multiples of 1/64, so that all sizes are exact.
    fn boxes(count: usize, room: u32, seed: u64) -> Vec<Aabb<Real, DIM>> {
        let mut random = oorandom::Rand32::new(seed);
        let mut place = || random.rand_range(0..64 * room) as Real / 64.0 - room as Real / 2.0;
        let mut aabb = || {
            let mins: [Real; DIM] = std::array::from_fn(|_| place());
            Aabb::new(mins, mins.map(|x| x + 1.0))
        };
        (0..count).map(|_| aabb()).collect()
    }

    #[test]
    fn boxes_no_larger_than_a_cell_are_all_found() {
        let cases = [(0, 1), (1, 1), (400, 2), (400, 8), (400, 30), (400, 1000)];
        for (seed, (count, room)) in (0..).zip(cases) {
            let mut boxes = boxes(count, room, seed);
            // Fewer than half are smaller, so that the median is still 1.
            for aabb in boxes.iter_mut().skip(1).step_by(3) {
                aabb.maxs = aabb.mins.map(|x| x + 0.25);
            }
            for cell in [Cell::Largest, Cell::Median] {
                assert_eq!(found(cell, &boxes), expected(&boxes), "in {room}");
            }
        }
    }
}
