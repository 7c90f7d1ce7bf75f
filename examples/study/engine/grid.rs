//! A hash grid of centres: each box is in the cell of its centre, and meets those in that cell and in the cells around it.
//!
//! Cells have the largest or the median size of what can move. With the median, a pair is missed whose centres are further apart
//! than its boxes allow for: two that are larger than a cell. Floors and walls, which are larger than anything that can move, are
//! compared with all others one by one. The cells are not hashed but sorted: the three cells of a row are then neighbours, and each
//! row of them is followed by an index that only grows.
//!
//! All pairs are found anew at each update, and compared with those held: **O(n log n + candidates)**.

use super::scenes::rapier::{math::DIM, parry::bounding_volume::BoundingVolume, prelude::*};
use super::version::BroadPhase;
use crate::finder::Cell;
use unisize::Aabb;

/// There are no more cells than this along an axis; what is beyond is in the last one.
const MOST_CELLS: u64 = 1 << 20;

/// Cells of one size, and what is in them.
pub(super) struct HashGrid {
    cell: Cell,
    /// By the index of the collider's handle.
    proxies: Vec<Option<Proxy>>,
    /// The pairs held, as sorted keys.
    held: Vec<u64>,
    /// Scratch memory: all boxes, the sizes of what can move, the boxes with the keys of their cells, and the pairs.
    by_size: BySize,
    sizes: Vec<Real>,
    entries: Vec<Entry>,
    pairs: Vec<[u32; 2]>,
    found: Vec<u64>,
}

/// A collider that a broad phase knows.
#[derive(Clone, Copy)]
struct Proxy {
    handle: ColliderHandle,
    can_move: bool,
    aabb: Aabb<Real, DIM>,
}

/// A box in its cell.
#[derive(Clone, Copy)]
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
            by_size: BySize::default(),
            sizes: Vec::new(),
            entries: Vec::new(),
            pairs: Vec::new(),
            found: Vec::new(),
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
    fn replace(&mut self, events: &mut Vec<BroadPhasePairEvent>) {
        let handle = |slot: u32| {
            let proxy = self.proxies[slot as usize];
            proxy
                .expect("the colliders of a held pair are known")
                .handle
        };
        let pair = |key: u64| ColliderPair::new(handle((key >> 32) as u32), handle(key as u32));
        let mut before = self.held.iter().copied().peekable();
        for &key in &self.found {
            while let Some(gone) = before.next_if(|&other| other < key) {
                events.push(BroadPhasePairEvent::DeletePair(pair(gone)));
            }
            if before.next_if_eq(&key).is_none() {
                events.push(BroadPhasePairEvent::AddPair(pair(key)));
            }
        }
        events.extend(before.map(|gone| BroadPhasePairEvent::DeletePair(pair(gone))));
        std::mem::swap(&mut self.held, &mut self.found);
    }

    /// Finds all pairs of indices, the smaller one first.
    fn find(&mut self) {
        let (mut by_size, mut pairs) = (
            std::mem::take(&mut self.by_size),
            std::mem::take(&mut self.pairs),
        );
        by_size.part(&self.proxies);
        by_size.find_large(&mut pairs);
        self.find_usual(&by_size.usual, &mut pairs);
        (self.by_size, self.pairs) = (by_size, pairs);
    }

    /// Finds the pairs of these boxes, which are not large.
    fn find_usual(&mut self, boxes: &[(u32, Aabb<Real, DIM>)], pairs: &mut Vec<[u32; 2]>) {
        let movable = self.proxies.iter().flatten().filter(|proxy| proxy.can_move);
        let size =
            |proxy: &Proxy| (0..DIM).fold(0.0, |max: Real, k| max.max(extent(&proxy.aabb, k)));
        self.sizes.clear();
        self.sizes.extend(movable.map(size));
        self.sizes.sort_by(Real::total_cmp);
        let cell = match self.cell {
            Cell::Largest => self.sizes.last(),
            Cell::Median => self.sizes.get(self.sizes.len() / 2),
        };
        let Some(&cell) = cell else {
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
            let skin = params.prediction_distance() / 2.0;
            let mut aabb = collider.compute_collision_aabb(skin);
            let body = collider.parent().map(|parent| &bodies[parent]);
            // As in Rapier's own, soft CCD looks ahead; here, as far as it may in a step.
            if let Some(body) = body.filter(|body| body.soft_ccd_prediction() > 0.0) {
                let pose = body.predict_position_using_velocity_and_forces(params.dt);
                let local = collider.position_wrt_parent().copied().unwrap_or_default();
                let next = collider.shape().compute_aabb(&(pose * local));
                aabb.merge(&next.loosened(collider.contact_skin() + skin));
            }
            let proxy = Proxy {
                handle,
                can_move: body.is_some_and(|body| !body.is_fixed()),
                aabb: Aabb::new(aabb.mins.coords.into(), aabb.maxs.coords.into()),
            };
            self.place(handle, Some(proxy));
        }
        self.pairs.clear();
        self.find();
        self.found.clear();
        let keys = self.pairs.iter();
        self.found
            .extend(keys.map(|&[a, b]| u64::from(a) << 32 | u64::from(b)));
        self.found.sort_unstable();
        self.replace(events);
    }
}

/// All boxes: those that are larger on some axis than any that can move, and the others.
#[derive(Default)]
struct BySize {
    /// The largest extent of a box that can move, on each axis.
    largest: [Real; DIM],
    usual: Vec<(u32, Aabb<Real, DIM>)>,
    large: Vec<(u32, Aabb<Real, DIM>)>,
}

impl BySize {
    /// Parts these boxes, in the order of their slots.
    fn part(&mut self, proxies: &[Option<Proxy>]) {
        let movable = proxies.iter().flatten().filter(|p| p.can_move);
        self.largest = movable.fold([0.0; DIM], |size: [Real; DIM], proxy| {
            std::array::from_fn(|k| size[k].max(extent(&proxy.aabb, k)))
        });
        let slots = (0..).zip(proxies);
        let boxes = slots.filter_map(|(slot, proxy)| Some((slot, proxy.as_ref()?.aabb)));
        self.usual.clear();
        self.large.clear();
        for (slot, aabb) in boxes {
            let is_usual = (0..DIM).all(|k| extent(&aabb, k) <= self.largest[k]);
            let part = if is_usual {
                &mut self.usual
            } else {
                &mut self.large
            };
            part.push((slot, aabb));
        }
    }

    /// Compares each large box with all others.
    fn find_large(&self, pairs: &mut Vec<[u32; 2]>) {
        for (index, &(slot, aabb)) in self.large.iter().enumerate() {
            let others = self.usual.iter().chain(&self.large[..index]);
            for &(other, _) in others.filter(|(_, other)| aabb.overlaps(other)) {
                pairs.push([slot.min(other), slot.max(other)]);
            }
        }
    }
}

fn extent(aabb: &Aabb<Real, DIM>, axis: usize) -> Real {
    aabb.maxs[axis] - aabb.mins[axis]
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
        grid.find();
        grid.pairs.sort_unstable();
        grid.pairs
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
            for cell in [Cell::Largest, Cell::Median] {
                assert_eq!(found(cell, &boxes), expected(&boxes), "in {room}");
            }
        }
    }

    #[test]
    fn boxes_larger_than_two_cells_are_missed() {
        let mut boxes = boxes(9, 1000, 1.0, 3);
        boxes.push(Aabb::new([0.0; DIM], [5.0; DIM]));
        boxes.push(Aabb::new([4.5; DIM], [9.5; DIM]));
        let pairs = expected(&boxes);
        assert!(pairs.contains(&[9, 10]));
        assert!(!found(Cell::Median, &boxes).contains(&[9, 10]));
        assert_eq!(found(Cell::Largest, &boxes), pairs);
    }

    #[test]
    fn there_may_be_nothing() {
        assert!(found(Cell::Median, &[]).is_empty());
        assert!(found(Cell::Largest, &boxes(1, 1, 1.0, 1)).is_empty());
    }
}
