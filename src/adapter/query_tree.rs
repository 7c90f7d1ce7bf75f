//! The tree that answers queries, kept between updates.
//!
//! It costs nothing until it is asked for: it is built at the first query, and brought up to date when the next one
//! comes. Its leaves are the boxes of the table, the same that Rapier's own broad phase has as its leaves, because some
//! answers depend on them: a query for boxes returns what its leaves are, and Parry's tests of shapes have a tolerance. Only
//! the boxes that were renewed are written, each in its place.

use std::sync::{Mutex, OnceLock, PoisonError};

use super::rapier::geometry::Aabb;
use super::rapier::math::{DIM, Real};
use super::rapier::parry::partitioning::{Bvh, BvhBuildStrategy, BvhWorkspace};
use crate::tuning::queries::{
    KEEP_UNASKED, OPTIMIZE_FROM_ONE_IN, PROPAGATE_UP_TO_ONE_IN, REORDER_FROM_ONE_IN, SMALL_UP_TO,
    TIGHTEN_FROM_ONE_IN,
};

/// The boxes by slot; invalid where there is none.
type Boxes<'a> = &'a [crate::Aabb<Real, DIM>];

/// The tree, if it was asked for recently.
#[derive(Default)]
pub(super) struct QueryTree {
    /// As of the last update.
    current: OnceLock<Tree>,
    /// As of an earlier update.
    outdated: Mutex<Option<Outdated>>,
    /// Updates since it was last asked for.
    unasked: u32,
}

/// A tree, and the slots whose boxes have changed since; some may occur more than once.
#[derive(Clone)]
struct Outdated {
    tree: Tree,
    renewed: Vec<u32>,
}

#[derive(Clone)]
struct Tree {
    bvh: Bvh,
    workspace: Workspace,
    leaves: usize,
    /// Leaves written since the tree was last optimized, and removed since its nodes were last put in order.
    written: usize,
    removed: usize,
    /// Whether a leaf is gone that could not be removed.
    is_unsound: bool,
    /// Leaves written whose ancestors may be larger than necessary.
    loose: usize,
    /// How many of the boxes handed over since the last update it has.
    seen: usize,
}

/// Scratch memory of Parry's, which cannot be cloned.
#[derive(Default)]
struct Workspace(BvhWorkspace);

impl Clone for Workspace {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl Clone for QueryTree {
    fn clone(&self) -> Self {
        Self {
            current: self.current.clone(),
            outdated: Mutex::new(self.lock().clone()),
            unasked: self.unasked,
        }
    }
}

impl QueryTree {
    /// Takes note of the boxes that an update has renewed, of this number of slots. A tree that is no longer asked for is
    /// given up in the end.
    pub(super) fn note(&mut self, renewed: &[u32], slots: usize) {
        if let Some(tree) = self.current.get_mut() {
            if tree.seen >= renewed.len() {
                // It is still up to date.
                tree.seen = 0;
                self.unasked = 0;
                return;
            }
        }
        self.unsettle();
        self.unasked = self.unasked.saturating_add(1);
        let is_given_up = self.unasked > KEEP_UNASKED;
        let outdated = self.outdated_mut();
        if is_given_up {
            *outdated = None;
        } else if let Some(Outdated { tree, renewed: all }) = outdated {
            all.extend_from_slice(&renewed[std::mem::take(&mut tree.seen).min(renewed.len())..]);
            if all.len() > slots {
                // Many have changed more than once, and no more than all can have.
                all.clear();
                all.extend(0..slots as u32);
            }
        }
    }

    /// Takes note that boxes have been handed over since it was last asked for.
    pub(super) fn unsettle(&mut self) {
        if let Some(tree) = self.current.take() {
            self.unasked = 0;
            *self.outdated_mut() = Some(Outdated {
                tree,
                renewed: Vec::new(),
            });
        }
    }

    /// The tree of these boxes, of which those of the `touched` slots were handed over since the last update.
    /// **O(n log n)** at first, then **O(n)** with a small constant once after boxes were renewed, and **O(1)** otherwise.
    pub(super) fn of(&self, boxes: Boxes, touched: &[u32]) -> &Bvh {
        let tree = self.current.get_or_init(|| {
            let mut tree = match self.lock().take() {
                Some(Outdated { tree, mut renewed }) => {
                    renewed.extend_from_slice(&touched[tree.seen.min(touched.len())..]);
                    tree.refreshed(boxes, &renewed)
                }
                None => Tree::new(boxes),
            };
            tree.seen = touched.len();
            tree
        });
        &tree.bvh
    }

    fn lock(&self) -> std::sync::MutexGuard<'_, Option<Outdated>> {
        self.outdated.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn outdated_mut(&mut self) -> &mut Option<Outdated> {
        self.outdated
            .get_mut()
            .unwrap_or_else(PoisonError::into_inner)
    }
}

impl Tree {
    fn new(boxes: Boxes) -> Self {
        let valid = boxes.iter().enumerate().filter(|(_, aabb)| aabb.is_valid());
        let leaves: Vec<_> = valid
            .map(|(slot, &aabb)| (slot, Aabb::from(aabb)))
            .collect();
        let count = leaves.len();
        let bvh = if count > 2 {
            Bvh::from_iter(BvhBuildStrategy::Binned, leaves)
        } else {
            // Parry builds trees of one and two leaves only if their indices are 0 and 1.
            let mut bvh = Bvh::new();
            for (slot, aabb) in leaves {
                bvh.insert(aabb, slot as u32);
            }
            bvh
        };
        Self {
            bvh,
            workspace: Workspace::default(),
            leaves: count,
            written: 0,
            removed: 0,
            is_unsound: false,
            loose: 0,
            seen: 0,
        }
    }

    /// The tree with the leaves of these slots brought up to date.
    fn refreshed(mut self, boxes: Boxes, renewed: &[u32]) -> Self {
        if renewed.len() * PROPAGATE_UP_TO_ONE_IN < self.leaves {
            for &slot in renewed {
                self.write(slot as usize, boxes, Bvh::insert);
            }
            self.loose += renewed.len();
        } else {
            for &slot in renewed {
                self.write(slot as usize, boxes, write_leaf);
            }
            self.loose = self.leaves;
        }
        if self.is_unsound {
            return Self::new(boxes);
        }
        if self.leaves <= SMALL_UP_TO {
            self.bvh.refit_without_opt();
            return self;
        }
        let is_due = self.written * OPTIMIZE_FROM_ONE_IN > self.leaves;
        if is_due {
            self.written = 0;
            self.bvh.optimize_incremental(&mut self.workspace.0);
        }
        if self.removed * REORDER_FROM_ONE_IN > self.leaves {
            self.removed = 0;
            self.loose = 0;
            self.bvh.refit(&mut self.workspace.0);
        } else if is_due || self.loose * TIGHTEN_FROM_ONE_IN > self.leaves {
            self.loose = 0;
            self.bvh.refit_without_opt();
        }
        self
    }

    /// Brings the leaf of a slot up to date; `insert` writes it if its box has changed.
    fn write(&mut self, slot: usize, boxes: Boxes, insert: impl Fn(&mut Bvh, Aabb, u32)) {
        if self.is_unsound {
            // It will be built afresh.
            return;
        }
        let leaf = self.bvh.leaf_node(slot as u32).map(|node| node.aabb());
        let aabb = &boxes[slot];
        if !aabb.is_valid() {
            if leaf.is_none() {
                return;
            }
            if self.leaves > SMALL_UP_TO {
                self.bvh.remove(slot as u32);
                self.removed += 1;
            } else {
                // Parry's trees that lose nearly all leaves are not sound.
                self.is_unsound = true;
            }
            self.leaves -= 1;
            return;
        }
        let aabb = Aabb::from(*aabb);
        if leaf != Some(aabb) {
            self.leaves += usize::from(leaf.is_none());
            self.written += 1;
            insert(&mut self.bvh, aabb, slot as u32);
        }
    }
}

/// Writes a leaf; its ancestors are updated afterwards.
fn write_leaf(bvh: &mut Bvh, aabb: Aabb, slot: u32) {
    bvh.insert_or_update_partially(aabb, slot, 0.0);
}
