//! Candidates as they are written and read by serde.

use serde::{Deserialize, Serialize};

use super::array::CandidateArray;
use super::{Candidates, ListState};
use crate::{Aabb, Real};

/// The candidates in their order, and whether there are lists of them.
#[derive(Serialize, Deserialize)]
pub(in crate::pair_tracker) struct CandidatesSnapshot {
    /// By row; `None` for tombstones, whose number decides when they are removed.
    pairs: Vec<Option<[u32; 2]>>,
    /// The rows whose boxes overlap and that are not held, because their volumes have not met.
    near: Vec<usize>,
    lists: ListState,
}

impl Candidates {
    pub(in crate::pair_tracker) fn snapshot(&self) -> CandidatesSnapshot {
        CandidatesSnapshot {
            pairs: (0..self.rows()).map(|row| self.array.get(row)).collect(),
            near: self.array.near().map(|(row, _)| row).collect(),
            lists: self.lists(),
        }
    }

    /// The candidates of these boxes. They must be the pairs that were `found`, in any order.
    ///
    /// # Errors
    /// What is wrong, if no candidates can have been written like this.
    pub(in crate::pair_tracker) fn restored<R: Real, const D: usize>(
        snapshot: CandidatesSnapshot,
        boxes: &[Aabb<R, D>],
        mut found: Vec<[u32; 2]>,
    ) -> Result<Self, &'static str> {
        let CandidatesSnapshot { pairs, near, lists } = snapshot;
        let mut kept: Vec<_> = pairs.iter().flatten().copied().collect();
        kept.sort_unstable();
        found.sort_unstable();
        if kept != found {
            return Err("snapshot: the candidates are not the pairs of overlapping fat boxes");
        }
        if !lists.can_occur(pairs.len()) {
            return Err("snapshot: the lists of candidates are out of range");
        }
        let mut candidates = Self {
            array: CandidateArray::new(pairs.into_iter(), boxes, &near)?,
            ..Self::default()
        };
        candidates
            .lists
            .restore(lists, &candidates.array, boxes.len());
        Ok(candidates)
    }
}
