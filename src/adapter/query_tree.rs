//! Scene queries: rays, points and shapes against the colliders, answered by a tree that is kept between updates.
//!
//! The first query builds the tree. The first query after an update brings it up to date; programs without queries pay nothing. The leaves are
//! the boxes of the table, the same as those of Rapier's own broad phase, because some answers depend on them: a query for boxes returns leaves,
//! and Parry's tests of shapes have a tolerance. Only the leaves of renewed boxes are written.

use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};

use super::rapier::geometry::Aabb as RapierAabb;
use super::rapier::math::{DIM, Real};
use super::rapier::parry::partitioning::{Bvh, BvhBuildStrategy, BvhWorkspace};
use crate::slot_set::SlotSet;
use crate::tuning::queries::{
    BUILD_FROM, FEW_UP_TO_ONE_IN, KEEP_UNASKED, SMALL_UP_TO, STRAY_SAMPLE, TIGHTEN_FROM_ONE_IN,
};

type Aabb = crate::aabb::Aabb<Real, DIM>;

/// The boxes by slot; invalid where there is no proxy.
type Boxes<'a> = &'a [Aabb];

/// The tree, if there were queries recently.
#[derive(Default)]
pub(super) struct QueryTree {
    /// The tree of the present boxes.
    current: OnceLock<Tree>,
    /// The tree of earlier boxes, if there is none of the present ones.
    outdated: Mutex<Option<Tree>>,
    /// The slots whose boxes or keys were written since the outdated tree was current. Unspecified if there is no outdated tree.
    written: SlotSet,
    /// The number of updates since a tree was current.
    unused: u32,
}

#[derive(Clone)]
struct Tree {
    bvh: Bvh,
    /// Scratch memory of Parry's.
    workspace: BvhWorkspace,
    /// By slot, the box for which its leaf was inserted, or an older one if the tree was small or many leaves were written.
    placed: Vec<Aabb>,
    /// The number of leaves that were written alone or removed since the last [refit](Bvh::refit).
    loose: usize,
}

impl Clone for QueryTree {
    fn clone(&self) -> Self {
        Self {
            current: self.current.clone(),
            outdated: Mutex::new(self.lock().clone()),
            written: self.written.clone(),
            unused: self.unused,
        }
    }
}

impl QueryTree {
    /// Notes that the boxes or keys of these slots were written. **O(1)** each, and **O(1)** in all without a tree.
    pub(super) fn note(&mut self, written: &[u32]) {
        if written.is_empty() {
            return;
        }
        let outdated = self.outdated.get_mut();
        let outdated = outdated.unwrap_or_else(PoisonError::into_inner);
        if let Some(tree) = self.current.take() {
            self.unused = 0;
            self.written.clear();
            *outdated = Some(tree);
        }
        if outdated.is_some() {
            self.written.add(written);
        }
    }

    /// Notes an update. A tree without queries is dropped after a while.
    pub(super) fn grow_older(&mut self) {
        if self.current.get().is_some() {
            self.unused = 0;
            return;
        }
        self.unused = self.unused.saturating_add(1);
        if self.unused > KEEP_UNASKED {
            *self.lock() = None;
            self.written = SlotSet::default();
        }
    }

    /// The tree of these boxes. **O(n log n)** at first, then **O(n)** with a small constant once after boxes were renewed, unless the
    /// tree has become too loose, and **O(1)** otherwise.
    pub(super) fn of(&self, boxes: Boxes) -> &Bvh {
        let tree = self.current.get_or_init(|| match self.lock().take() {
            Some(tree) => tree.refreshed(boxes, &self.written),
            None => Tree::new(boxes),
        });
        &tree.bvh
    }

    /// Panics unless the leaves of the refreshed tree, if there is one, are these boxes.
    pub(super) fn validate(&self, boxes: Boxes) {
        let refreshed = || Some(self.lock().clone()?.refreshed(boxes, &self.written));
        let Some(tree) = self.current.get().cloned().or_else(refreshed) else {
            return;
        };
        let valid = (0..).zip(boxes).filter(|(_, aabb)| aabb.is_valid());
        let mut count = 0;
        for (slot, &aabb) in valid {
            let leaf = tree.bvh.leaf_node(slot).map(|leaf| leaf.aabb());
            assert_eq!(leaf, Some(aabb.into()), "the leaf of slot {slot}");
            count += 1;
        }
        assert_eq!(tree.bvh.leaf_count(), count, "leaves");
    }

    fn lock(&self) -> MutexGuard<'_, Option<Tree>> {
        self.outdated.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Tree {
    fn new(boxes: Boxes) -> Self {
        let valid = boxes.iter().enumerate().filter(|(_, aabb)| aabb.is_valid());
        let leaves = valid.map(|(slot, &aabb)| (slot, RapierAabb::from(aabb)));
        let leaves: Vec<_> = leaves.collect();
        let bvh = if leaves.len() > 2 {
            Bvh::from_iter(BvhBuildStrategy::Binned, leaves)
        } else {
            // Parry builds a tree of one or two leaves only if their indices are 0 and 1.
            let mut bvh = Bvh::new();
            for (slot, aabb) in leaves {
                bvh.insert(aabb, slot as u32);
            }
            bvh
        };
        Self {
            bvh,
            workspace: BvhWorkspace::default(),
            placed: boxes.to_vec(),
            loose: 0,
        }
    }

    /// Returns the tree with the leaves of these slots written again.
    ///
    /// A leaf that has moved far since it was inserted makes its ancestors large, and rays then visit more nodes. If few leaves have moved,
    /// each such leaf is inserted again. If many have moved, they usually move far at about the same time. Then the tree is built again.
    fn refreshed(mut self, boxes: Boxes, written: &SlotSet) -> Self {
        // Threads note slots in another order, and the order decides what the tree is like.
        let mut renewed = written.slots().to_vec();
        renewed.sort_unstable();
        let leaves = self.bvh.leaf_count() as usize;
        self.placed.resize(boxes.len(), Aabb::ABSENT);
        let are_few = renewed.len() * FEW_UP_TO_ONE_IN < leaves;
        if !are_few && self.have_strayed(boxes, &renewed) {
            return Self::new(boxes);
        }
        for slot in renewed {
            let aabb = boxes[slot as usize];
            if !aabb.is_valid() {
                if self.bvh.leaf_count() <= SMALL_UP_TO {
                    return Self::new(boxes);
                }
                self.bvh.remove(slot);
                self.loose += 1;
            } else if are_few {
                self.write(slot, aabb);
            } else {
                self.bvh.insert_or_update_partially(aabb.into(), slot, 0.0);
            }
        }
        if leaves <= SMALL_UP_TO as usize {
            // In so small a tree, sorting the nodes gains nothing.
            self.bvh.refit_without_opt();
            return self;
        }
        if self.loose * TIGHTEN_FROM_ONE_IN > leaves {
            self.loose = 0;
            self.bvh.refit(&mut self.workspace);
        } else if !are_few {
            self.bvh.refit_without_opt();
        }
        self
    }

    /// Whether a sample shows that many of these leaves have left the boxes for which they were inserted.
    fn have_strayed(&self, boxes: Boxes, renewed: &[u32]) -> bool {
        let sample = renewed.iter().step_by(renewed.len() / STRAY_SAMPLE + 1);
        let count = sample.len();
        let strays = sample.filter(|&&slot| {
            let i = slot as usize;
            boxes[i].is_valid() && !boxes[i].intersects(&self.placed[i])
        });
        strays.count() as f64 > BUILD_FROM * count as f64
    }

    /// Writes the leaf of a slot and its ancestors.
    fn write(&mut self, slot: u32, aabb: Aabb) {
        let placed = &mut self.placed[slot as usize];
        if !aabb.intersects(placed) && self.bvh.leaf_count() > SMALL_UP_TO {
            *placed = aabb;
            self.bvh.remove(slot);
            self.loose += 1;
        }
        self.bvh.insert(aabb.into(), slot);
        self.loose += 1;
    }
}
