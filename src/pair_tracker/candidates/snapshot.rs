//! Candidates as they are written and read by serde.

use serde::{Deserialize, Serialize};

use super::{Candidates, GONE, LINK_COST, MOST_LINKED, overlap};
use crate::{Aabb, Real};

/// The candidates in their order, and whether there are lists of them.
#[derive(Serialize, Deserialize)]
pub(in crate::pair_tracker) struct CandidatesSnapshot {
    /// `None` where there is none any more: how many those are decides when they are forgotten.
    pairs: Vec<Option<[u32; 2]>>,
    are_linked: bool,
    links_wanted: u32,
}

impl Candidates {
    pub(in crate::pair_tracker) fn snapshot(&self) -> CandidatesSnapshot {
        let pairs = self.pairs.iter();
        CandidatesSnapshot {
            pairs: pairs
                .map(|&pair| (pair[0] != GONE).then_some(pair))
                .collect(),
            are_linked: self.links.are_made,
            links_wanted: self.links.wanted,
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
            return Err("the candidates are not the overlapping reaches");
        }
        let pairs = self.pairs.into_iter();
        let mut candidates = Candidates {
            pairs: pairs.map(|pair| pair.unwrap_or([GONE; 2])).collect(),
            ..Candidates::default()
        };
        let all = candidates.pairs.iter();
        candidates.held = all
            .map(|&pair| pair[0] != GONE && overlap(boxes, pair))
            .collect();
        candidates.held_count = candidates.held().count();
        candidates.gone_count = candidates.pairs.len() - found.len();
        if self.links_wanted > LINK_COST + 1
            || self.are_linked && candidates.pairs.len() > MOST_LINKED
        {
            return Err("no links are like that");
        }
        if self.are_linked {
            candidates.links.make(&candidates.pairs, boxes.len());
        }
        candidates.links.wanted = self.links_wanted;
        Ok(candidates)
    }
}
