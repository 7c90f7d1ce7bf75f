//! A size class: its boxes are assigned to the tubes of a grid, and each tube is sorted and swept.

use super::assignment::Assignment;
use super::choose::{sample_indices, share_along_first_axis};
use super::emitter::{Emitter, Tally};
use super::entry::{Entry, Owner};
use super::grid::{Grid, cut_axes};
use super::search::{Members, Search};
use super::slab::Slab;
use crate::aabb::Aabb;
use crate::invalid_input::InvalidInput;
use crate::real::Real;
use crate::tuning::kernel::{
    COMPARED_A_PAIR, COMPARED_AN_ENTRY, CROWD_ROOM, CROWD_TRIES, EFFORT_SAMPLE,
    GRID_SIZE_QUANTILES, GRID_TRIES, ONE_TUBE_UP_TO, QUERY,
};

/// The boxes of a size class, sorted into tubes.
#[derive(Clone, Debug, Default)]
pub(super) struct Class<R, const D: usize> {
    pub(super) grid: Grid<R>,
    /// Together they cover the grid.
    pub(super) slabs: Vec<Slab<R, D>>,
    /// A box around those of the class; for look-ups.
    pub(super) bounds: Option<Aabb<R, D>>,
    /// The same boxes in a single tube, if some queries reach very many tubes.
    pub(super) row: Option<Box<Self>>,
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
        self.row = None;
        let room = self.assign(members, oversized, assignment, search)?;
        assignment.place(members);
        search.keeps |= !oversized.is_empty();
        let ranges = assignment.split();
        self.slabs.resize_with(ranges.len(), Slab::default);
        for (slab, range) in self.slabs.iter_mut().zip(ranges) {
            slab.reset(range, search.keeps);
        }
        let (slabs, section) = (&mut self.slabs, assignment.section);
        let sweep = |slab: &mut Slab<R, D>, emitter: &mut Emitter| {
            slab.sweep(members.boxes, assignment, room, emitter);
        };
        search.collect(section, slabs, |slab| &mut slab.found, sweep);
        Ok(())
    }

    /// Chooses a grid and counts the entries of its tubes. If no grid suits the boxes, there is one tube. Returns the room of crowds in its
    /// tubes: less than 1 if a further grid would not separate them.
    ///
    /// Each class must take a fair share of the boxes, so that there are few classes, unless a plain sweep is fast for those that it leaves.
    /// The last resort, one tube, takes all that are not much longer than those of a sample, and for the last class all. A crowd comes from a
    /// single tube. Its grid must leave at most three quarters of its comparisons, or few because short boxes stand in a row along the first
    /// axis.
    fn assign(
        &mut self,
        members: Members<R, D>,
        oversized: &mut Vec<u32>,
        assignment: &mut Assignment,
        search: &Search<R, D>,
    ) -> Result<f64, InvalidInput> {
        let (count, is_crowd) = (members.count(), search.room.is_some());
        let tries = match count {
            ..=ONE_TUBE_UP_TO => &[][..],
            _ if search.is_last_class => &[],
            _ if is_crowd => &CROWD_TRIES,
            _ => &GRID_TRIES,
        };
        for &aim in tries {
            self.grid = Grid::choose(members, cut_axes::<D>(), aim, is_crowd);
            assignment.count(members, &self.grid, oversized)?;
            let taken = count - oversized.len();
            // Whether a sweep takes few comparisons for each box, since it compares only boxes that overlap along the first axis.
            let are_few = |comparisons: f64, boxes: usize, are_taken| {
                let share = share_along_first_axis(members, &self.grid, are_taken);
                comparisons * share <= COMPARED_AN_ENTRY as f64 * boxes as f64
            };
            if taken <= count / 8 {
                let left = oversized.len();
                let is_worth_it = is_crowd && taken > 0;
                if !(is_worth_it && are_few((left as f64).powi(2), left, false)) {
                    continue;
                }
            }
            let Some(room) = search.room else {
                return Ok(CROWD_ROOM);
            };
            let [entries, comparisons] = assignment.comparisons().map(|count| count as f64);
            let room = room * taken as f64 / entries;
            if room < 1.0 {
                continue;
            }
            if comparisons <= 0.75 * (taken as f64).powi(2) {
                return Ok(room / 2.0);
            }
            if are_few(comparisons, taken, true) {
                return Ok(0.0);
            }
        }
        self.grid = match tries {
            [] => Grid::default(),
            [.., (sample, _)] => Grid::choose(members, 0, (*sample, GRID_SIZE_QUANTILES), is_crowd),
        };
        assignment.count(members, &self.grid, oversized)?;
        Ok(if is_crowd { 0.0 } else { CROWD_ROOM })
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

    /// Sorts the members, whose boxes these are, into a single tube as well, unless that is done.
    pub(super) fn add_row(&mut self, members: &[u32], boxes: &[Aabb<R, D>]) {
        if self.row.is_some() {
            return;
        }
        let entries = members.iter().map(|&i| Entry {
            aabb: boxes[i as usize],
            owner: Owner(i),
        });
        let mut slab = Slab::default();
        slab.reset(0..1, true);
        slab.push(0, &entries.collect::<Vec<_>>());
        slab.free_scratch();
        let mut row = Self {
            slabs: vec![slab],
            ..Self::default()
        };
        row.prepare_lookup();
        self.row = Some(Box::new(row));
    }

    /// An estimate of the comparisons for looking these boxes up in the class, besides some for each pair, by a sample of them.
    pub(super) fn effort(&self, queries: &[u32], boxes: &[Aabb<R, D>]) -> f64 {
        let (mut pairs, mut count) = (Vec::new(), 0);
        let mut emitter = Emitter::new(&mut pairs, usize::MAX);
        for i in sample_indices(queries.len(), EFFORT_SAMPLE) {
            self.look_up_box(&boxes[queries[i] as usize], queries[i], &mut emitter);
            count += 1;
        }
        let Tally { compared, emitted } = emitter.finish();
        let besides = compared.saturating_sub(COMPARED_A_PAIR * emitted);
        (QUERY + besides as f64 / f64::from(count.max(1))) * queries.len() as f64
    }
}
