//! A size class: its boxes are assigned to the tubes of a grid, and each tube is sorted and swept.

use super::assignment::Assignment;
use super::choose::{excess, sample_indices};
use super::grid::Grid;
use super::search::{Members, Search};
use super::slab::Slab;
use super::worker::{Tally, Worker};
use crate::aabb::Aabb;
use crate::invalid_input::InvalidInput;
use crate::real::Real;
use crate::tuning::kernel::{
    COMPARED_A_PAIR, EFFORT_SAMPLE, FAR_FEWER, GRID_TRIES, ONE_TUBE_UP_TO, QUERY, SECOND_SAMPLE,
};

/// The boxes of a size class, sorted into tubes.
#[derive(Clone, Debug, Default)]
pub(super) struct Class<R, const D: usize> {
    pub(super) grid: Grid<R>,
    /// Together they cover the grid.
    pub(super) slabs: Vec<Slab<R, D>>,
    /// A box around those of the class; for look-ups.
    pub(super) bounds: Option<Aabb<R, D>>,
}

impl<R: Real, const D: usize> Class<R, D> {
    /// Sorts the members into tubes, and appends their pairs. Replaces `oversized` by the members that are left to further classes.
    pub(super) fn search(
        &mut self,
        members: Members<R, D>,
        oversized: &mut Vec<u32>,
        assignment: &mut Assignment,
        search: &mut Search<R, D>,
    ) -> Result<(), InvalidInput> {
        self.assign(members, oversized, assignment, search)?;
        assignment.place(members);
        if !search.is_last_class {
            if let Some(staying) = assignment.without_crowds(members, oversized) {
                let members = Members {
                    indices: Some(&staying),
                    ..members
                };
                assignment.count(members, &self.grid, &mut Vec::new())?;
                assignment.place(members);
            }
        }
        search.keeps |= !oversized.is_empty();
        let (keeps, section, ranges) = (search.keeps, assignment.section, assignment.split());
        self.slabs.resize_with(ranges.len(), Slab::default);
        for (slab, range) in self.slabs.iter_mut().zip(ranges) {
            slab.range = range;
        }
        search.collect(section, self.slabs.iter_mut(), |slab, worker| {
            slab.sweep(members.boxes, assignment, keeps, worker);
        });
        Ok(())
    }

    /// Chooses a grid and counts the entries of its tubes.
    ///
    /// A grid *fits* if the sweep takes few comparisons for each box and pair. Each try is counted, and the first grid that nearly fits is
    /// swept, because the boxes of its crowded tubes are left to further classes; if none does, the first one, unless a later one takes far
    /// fewer comparisons. Each class must take a fair share of the boxes, so that there are few classes. Where no grid does, and for the last
    /// class, one tube takes all boxes.
    fn assign(
        &mut self,
        members: Members<R, D>,
        oversized: &mut Vec<u32>,
        assignment: &mut Assignment,
        search: &Search<R, D>,
    ) -> Result<(), InvalidInput> {
        let count = members.count();
        let tries = match count {
            ..=ONE_TUBE_UP_TO => &[][..],
            _ if search.is_last_class => &[],
            _ => &GRID_TRIES,
        };
        let mut best = None;
        for aim in tries {
            if best.is_some() && aim.sample == SECOND_SAMPLE {
                break;
            }
            self.grid = Grid::choose(members, *aim);
            assignment.count(members, &self.grid, oversized)?;
            let taken = count - oversized.len();
            if taken <= count / 8 {
                continue;
            }
            let excess = excess(members, &self.grid, taken, assignment.comparisons() as f64);
            if excess <= FAR_FEWER {
                return Ok(());
            }
            if best.is_none_or(|(least, _)| excess < least / FAR_FEWER) {
                best = Some((excess, aim));
            }
        }
        self.grid = best.map_or_else(Grid::default, |(_, aim)| Grid::choose(members, *aim));
        assignment.count(members, &self.grid, oversized)
    }

    /// Replaces `members` by the boxes of the class, in the order of its tubes.
    pub(super) fn list_members(&self, members: &mut Vec<u32>) {
        members.clear();
        for slab in &self.slabs {
            for tube in &slab.tubes {
                let owners = &slab.owners[tube.start as usize..tube.end as usize];
                let at_home = owners.iter().filter(|owner| owner.is_at_home());
                members.extend(at_home.map(|owner| owner.index()));
            }
        }
    }

    /// An estimate of the comparisons for looking these boxes up in the class, besides some for each pair, by a sample of them.
    pub(super) fn effort(&self, queries: &[u32], boxes: &[Aabb<R, D>]) -> f64 {
        let (mut pairs, mut count) = (Vec::new(), 0);
        let mut worker = Worker::new(&mut pairs, usize::MAX);
        for i in sample_indices(queries.len(), EFFORT_SAMPLE) {
            self.look_up(boxes, queries[i], &mut worker);
            count += 1;
        }
        let Tally { compared, emitted } = worker.finish();
        let besides = compared.saturating_sub(COMPARED_A_PAIR * emitted);
        (QUERY + besides as f64 / f64::from(count.max(1))) * queries.len() as f64
    }
}
