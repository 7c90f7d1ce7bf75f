//! Scene queries: rays, points and shapes against the colliders, and the tree that answers them, kept between updates.
//!
//! The tree costs nothing until it is asked for: it is built at the first query, and brought up to date when the next one
//! comes. Its leaves are the boxes of the table, the same that Rapier's own broad phase has as its leaves, because some
//! answers depend on them: a query for boxes returns what its leaves are, and Parry's tests of shapes have a tolerance. Only
//! the boxes that were renewed are written, each in its place.

use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};

use super::UnisizeBroadPhase;
use super::rapier::dynamics::RigidBodySet;
use super::rapier::geometry::{Aabb as RapierAabb, ColliderSet};
use super::rapier::math::{DIM, Real};
use super::rapier::parry::partitioning::{Bvh, BvhBuildStrategy, BvhWorkspace, TraversalAction};
use super::rapier::parry::query::QueryDispatcher;
use super::rapier::pipeline::{QueryFilter, QueryPipeline, QueryPipelineMut};
use crate::slot_set::SlotSet;
use crate::tuning::queries::{
    BUILD_FROM_GIRTH, FEW_UP_TO_ONE_IN, JUDGE_FROM_ONE_IN, KEEP_UNASKED, SMALL_UP_TO, STRAY_SAMPLE,
    TIGHTEN_FROM_ONE_IN,
};

type Aabb = crate::aabb::Aabb<Real, DIM>;

/// The boxes by slot; invalid where there is none.
type Boxes<'a> = &'a [Aabb];

impl UnisizeBroadPhase {
    /// The scene as of the last update, for queries. The counterpart of `BroadPhaseBvh::as_query_pipeline`.
    ///
    /// The first call builds a tree in **O(n log n)**, which is kept as long as there are calls. The first call after an
    /// update brings it up to date, in about a tenth of that time. Further calls are free.
    ///
    /// Its boxes are those of Rapier's own broad phase. Of colliders at exactly the same distance, a query may find another one.
    pub fn as_query_pipeline<'a>(
        &'a self,
        dispatcher: &'a dyn QueryDispatcher,
        bodies: &'a RigidBodySet,
        colliders: &'a ColliderSet,
        filter: QueryFilter<'a>,
    ) -> QueryPipeline<'a> {
        QueryPipeline {
            dispatcher,
            bvh: self.tree(),
            bodies,
            colliders,
            filter,
        }
    }

    /// The same with the sets borrowed mutably. The counterpart of `BroadPhaseBvh::as_query_pipeline_mut`.
    pub fn as_query_pipeline_mut<'a>(
        &'a self,
        dispatcher: &'a dyn QueryDispatcher,
        bodies: &'a mut RigidBodySet,
        colliders: &'a mut ColliderSet,
        filter: QueryFilter<'a>,
    ) -> QueryPipelineMut<'a> {
        QueryPipelineMut {
            dispatcher,
            bvh: self.tree(),
            bodies,
            colliders,
            filter,
        }
    }

    pub(crate) fn tree(&self) -> &Bvh {
        self.query_tree.of(self.table.boxes())
    }
}

/// The tree, if it was asked for recently.
#[derive(Default)]
pub(super) struct QueryTree {
    /// With the present boxes.
    current: OnceLock<Tree>,
    /// With earlier boxes.
    outdated: Mutex<Option<Tree>>,
    /// Updates since it was last asked for.
    unasked: u32,
}

#[derive(Clone)]
struct Tree {
    bvh: Bvh,
    workspace: Workspace,
    /// By slot, the box for which the place of the leaf was chosen, or with which it was last judged.
    placed: Vec<Aabb>,
    /// Its girth when it was built.
    girth: u64,
    /// Leaves written alone or removed since the nodes were last put in order.
    loose: usize,
    /// The slots whose boxes were written since; none if it is current.
    outdated: SlotSet,
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
    /// Takes note that the boxes of these slots were written. **O(1)** each, and **O(1)** in all if there is no tree.
    pub(super) fn note(&mut self, written: &[u32]) {
        if written.is_empty() {
            return;
        }
        let outdated = self.outdated.get_mut();
        let outdated = outdated.unwrap_or_else(PoisonError::into_inner);
        if let Some(tree) = self.current.take() {
            self.unasked = 0;
            *outdated = Some(tree);
        }
        if let Some(tree) = outdated {
            let highest = written.iter().fold(0, |highest, &slot| highest.max(slot));
            tree.outdated.make_room(highest as usize + 1);
            for &slot in written {
                tree.outdated.insert(slot);
            }
        }
    }

    /// Takes note of an update. A tree that is no longer asked for is given up in the end.
    pub(super) fn grow_older(&mut self) {
        if self.current.get().is_some() {
            self.unasked = 0;
            return;
        }
        self.unasked = self.unasked.saturating_add(1);
        if self.unasked > KEEP_UNASKED {
            *self.lock() = None;
        }
    }

    /// The tree of these boxes. **O(n log n)** at first, then **O(n)** with a small constant once after boxes were renewed, and
    /// **O(1)** otherwise.
    pub(super) fn of(&self, boxes: Boxes) -> &Bvh {
        let tree = self.current.get_or_init(|| match self.lock().take() {
            Some(tree) => tree.refreshed(boxes),
            None => Tree::new(boxes),
        });
        &tree.bvh
    }

    /// Panics unless the leaves of the tree, if there is one, are these boxes, once it is brought up to date.
    pub(super) fn validate(&self, boxes: Boxes) {
        let outdated = || Some(self.lock().clone()?.refreshed(boxes));
        let Some(tree) = self.current.get().cloned().or_else(outdated) else {
            return;
        };
        assert!(tree.outdated.slots().is_empty(), "it is brought up to date");
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
            // Parry builds trees of one and two leaves only if their indices are 0 and 1.
            let mut bvh = Bvh::new();
            for (slot, aabb) in leaves {
                bvh.insert(aabb, slot as u32);
            }
            bvh
        };
        Self {
            girth: girth(&bvh),
            bvh,
            workspace: Workspace::default(),
            placed: boxes.to_vec(),
            loose: 0,
            outdated: SlotSet::default(),
        }
    }

    /// The tree with its outdated leaves brought up to date.
    ///
    /// A leaf that has gone far from where its place was chosen makes its ancestors large, and rays visit more of the
    /// tree. If few have moved, it gets a new place. If many have, they go far at about the same time: then, unless what was near
    /// each other has gone together, the tree is built afresh.
    fn refreshed(mut self, boxes: Boxes) -> Self {
        let mut outdated = std::mem::take(&mut self.outdated);
        let mut tree = self.with_renewed(boxes, outdated.slots());
        outdated.clear();
        tree.outdated = outdated;
        tree
    }

    fn with_renewed(mut self, boxes: Boxes, renewed: &[u32]) -> Self {
        let leaves = self.bvh.leaf_count() as usize;
        let are_few = renewed.len() * FEW_UP_TO_ONE_IN < leaves;
        self.placed.resize(boxes.len(), Aabb::ABSENT);
        for &slot in renewed {
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
            // In a tree so small, another order of the nodes gains nothing.
            self.bvh.refit_without_opt();
            return self;
        }
        if self.loose * TIGHTEN_FROM_ONE_IN > leaves {
            self.loose = 0;
            self.bvh.refit(&mut self.workspace.0);
        } else if !are_few {
            self.bvh.refit_without_opt();
        }
        if !are_few && self.have_strayed(boxes, renewed) {
            if girth(&self.bvh) > self.girth + BUILD_FROM_GIRTH {
                return Self::new(boxes);
            }
            self.placed.copy_from_slice(boxes);
        }
        self
    }

    /// Whether many of these leaves have left the boxes for which their places were chosen, by a sample.
    fn have_strayed(&self, boxes: Boxes, renewed: &[u32]) -> bool {
        let sample = renewed.iter().step_by(renewed.len() / STRAY_SAMPLE + 1);
        let count = sample.len();
        let strays = sample.filter(|&&slot| {
            let i = slot as usize;
            boxes[i].is_valid() && !boxes[i].intersects(&self.placed[i])
        });
        strays.count() * JUDGE_FROM_ONE_IN > count
    }

    /// Brings the leaf of a slot and its ancestors up to date.
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

/// How large the nodes of a tree are that have children: the mean of the logarithms of their areas, or perimeters in the
/// plane, in units of 2^-20 octaves. Logarithms, because a few nodes around a half-space must not hide what happens to
/// the rest.
fn girth(bvh: &Bvh) -> u64 {
    let (mut sum, mut nodes) = (0, 0);
    bvh.traverse(|node| {
        if node.is_leaf() {
            return TraversalAction::Prune;
        }
        sum += octaves(f64::from(node.aabb().half_area_or_perimeter()));
        nodes += 1;
        TraversalAction::Continue
    });
    sum.checked_div(nodes).unwrap_or(0)
}

/// The logarithm of a number that is not negative, in units of 2^-20 octaves from anywhere: its upper bits are that, but for the curve
/// between two powers of two.
fn octaves(number: f64) -> u64 {
    number.to_bits() >> 32
}

#[cfg(test)]
mod tests {
    use super::{Aabb, Boxes, DIM, Real, Tree};

    const COUNT: usize = 1000;

    /// Unit boxes in cells that are two wide, each in the cell of this number, shifted along the first axis.
    fn boxes(cell: impl Fn(usize) -> usize, shift: Real) -> Vec<Aabb> {
        let columns = (COUNT as f64).powf(1.0 / DIM as f64).ceil() as usize;
        let slots = 0..COUNT;
        let boxes = slots.map(|slot| {
            let mut rest = cell(slot);
            let mut mins = [0.0; DIM];
            for min in &mut mins {
                *min = (rest % columns * 2) as Real;
                rest /= columns;
            }
            mins[0] += shift;
            Aabb::new(mins, mins.map(|min| min + 1.0))
        });
        boxes.collect()
    }

    /// Whether the tree of boxes is built afresh once they are others, all of which have left their places.
    fn is_built_afresh(before: Boxes, now: Boxes) -> bool {
        let mut tree = Tree::new(before);
        // A new one has no loose leaves.
        tree.loose = 1;
        tree.outdated.make_room(COUNT);
        (0..COUNT as u32).for_each(|slot| tree.outdated.insert(slot));
        let tree = tree.refreshed(now);
        for (slot, aabb) in now.iter().enumerate() {
            let leaf = tree.bvh.leaf_node(slot as u32).map(|node| node.aabb());
            assert_eq!(leaf, Some((*aabb).into()));
        }
        tree.loose == 0
    }

    #[test]
    fn only_what_is_mixed_gets_a_new_tree() {
        let mut before = boxes(|slot| slot, 0.0);
        let mut mixed = boxes(|slot| slot * 37 % COUNT, 100.0);
        assert!(!is_built_afresh(&before, &boxes(|slot| slot, 100.0)));
        assert!(is_built_afresh(&before, &mixed));
        // A half-space around all does not hide it.
        for boxes in [&mut before, &mut mixed] {
            boxes[0] = Aabb::new([-1e18; DIM], [1e18; DIM]);
        }
        assert!(is_built_afresh(&before, &mixed));
    }
}
