//! What Rapier 0.27 spells in its own way: nalgebra's vectors, and a trait for broad phases.

use super::grid::HashGrid;
use super::scenes::rapier::{math, prelude::*};
use crate::finder::Cell;

pub(super) use super::scenes::rapier::geometry::BroadPhase;

pub(super) type Vector = math::Vector<Real>;
pub(super) type Point = math::Point<Real>;
pub(super) type AngVector = math::AngVector<Real>;

/// A step asks no tree.
pub(super) fn on_rapiers_tree<B: BroadPhase>(broad_phase: B) -> B {
    broad_phase
}

/// A broad phase that is a hash grid of centres.
pub(super) fn hash_grid(cell: Cell) -> Option<HashGrid> {
    Some(HashGrid::new(cell))
}

/// What only a later version asks of a broad phase.
macro_rules! when_boxes_are_handed_over {
    ($($item:item)*) => {};
}
pub(super) use when_boxes_are_handed_over;
