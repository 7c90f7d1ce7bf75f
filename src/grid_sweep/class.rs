//! A size class: its boxes are assigned to the tubes of a grid, and each tube is sorted and swept.

use super::assignment::Assignment;
use super::choose::{excess, sample_indices};
use super::emitter::{Emitter, Tally};
use super::grid::{Grid, cut_axes};
use super::search::{Members, Search};
use super::slab::Slab;
use crate::aabb::Aabb;
use crate::invalid_input::InvalidInput;
use crate::real::Real;
use crate::tuning::kernel::{
    Aim, COMPARED_A_PAIR, CROWD_ROOM, CROWD_TRIES, EFFORT_SAMPLE, FAR_FEWER, GRID_SIZE_QUANTILES,
    GRID_TRIES, ONE_TUBE_UP_TO, QUERY, SECOND_SAMPLE,
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

    /// Chooses a grid and counts the entries of its tubes. Returns the room of crowds in its tubes: less than 1 if a further grid would not
    /// separate them.
    ///
    /// A grid *fits* if the sweep takes few comparisons for each box and pair. Each try is counted, and the first grid that nearly fits is
    /// swept, because its crowded tubes get grids of their own; if none does, the first one, unless a later one takes far fewer comparisons. Each class must take a fair share of the boxes, so that
    /// there are few classes. The last resort, one tube, takes all that are not much longer than those of a sample, and for the last class
    /// all.
    ///
    /// A crowd comes from a single tube. Its grid must leave at most three quarters of its comparisons, or fit because short boxes stand in a
    /// row along the first axis. It may take few boxes if a plain sweep is fast for the others.
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
        let mut best = None;
        for aim in tries {
            if best.is_some() && aim.sample == SECOND_SAMPLE {
                break;
            }
            self.grid = Grid::choose(members, cut_axes::<D>(), *aim);
            assignment.count(members, &self.grid, oversized)?;
            let taken = count - oversized.len();
            if taken <= count / 8 {
                let left = oversized.len();
                let is_worth_it = is_crowd && taken > 0;
                let excess = || excess(members, &self.grid, false, left, (left as f64).powi(2));
                if !(is_worth_it && excess() <= 1.0) {
                    continue;
                }
            }
            let [entries, comparisons] = assignment.comparisons().map(|count| count as f64);
            let excess = || excess(members, &self.grid, true, taken, comparisons);
            if let Some(room) = search.room {
                let room = room * taken as f64 / entries;
                if room >= 1.0 && comparisons <= 0.75 * (taken as f64).powi(2) {
                    return Ok(room / 2.0);
                }
                if room >= 1.0 && excess() <= 1.0 {
                    return Ok(0.0);
                }
                continue;
            }
            let excess = excess();
            if excess <= FAR_FEWER {
                return Ok(CROWD_ROOM);
            }
            if best.is_none_or(|(least, _)| excess < least / FAR_FEWER) {
                best = Some((excess, aim));
            }
        }
        self.grid = match (best, tries) {
            (Some((_, aim)), _) => Grid::choose(members, cut_axes::<D>(), *aim),
            (_, []) => Grid::default(),
            (_, [.., last]) => Grid::choose(
                members,
                0,
                Aim {
                    sizes: GRID_SIZE_QUANTILES,
                    ..*last
                },
            ),
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
