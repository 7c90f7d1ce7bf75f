//! Candidates as they are written and read by serde.

use serde::{Deserialize, Serialize};

use super::array::CandidateArray;
use super::{Candidates, Lists};
use crate::{Aabb, Real};

/// The candidates in their order, and whether there are lists of them.
#[derive(Serialize, Deserialize)]
pub(in crate::pair_tracker) struct CandidatesSnapshot {
    /// By row; `None` for tombstones, whose number decides when they are removed.
    pairs: Vec<Option<[u32; 2]>>,
    lists: Lists,
}

impl Candidates {
    pub(in crate::pair_tracker) fn snapshot(&self) -> CandidatesSnapshot {
        CandidatesSnapshot {
            pairs: (0..self.rows()).map(|row| self.array.get(row)).collect(),
            lists: self.lists(),
        }
    }
}

impl CandidatesSnapshot {
    /// The candidates of these boxes, which must be those that were `found`, in any order.
    pub(in crate::pair_tracker) fn restore<R: Real, const D: usize>(
        self,
        boxes: &[Aabb<R, D>],
        mut found: Vec<[u32; 2]>,
    ) -> Result<Candidates, &'static str> {
        let mut kept: Vec<_> = self.pairs.iter().flatten().copied().collect();
        kept.sort_unstable();
        found.sort_unstable();
        if kept != found {
            return Err("snapshot: the candidates are not the pairs of overlapping fat boxes");
        }
        if !self.lists.are_sound(self.pairs.len()) {
            return Err("snapshot: the lists of candidates are out of range");
        }
        let mut candidates = Candidates {
            array: CandidateArray::new(self.pairs.into_iter(), boxes),
            ..Candidates::default()
        };
        candidates
            .lists
            .restore(self.lists, &candidates.array, boxes.len());
        Ok(candidates)
    }
}
