//! A size class: its boxes are assigned to the tubes of a grid, and each tube is sorted and swept.

use super::assignment::Assignment;
use super::choose::{excess, sample_of};
use super::grid::Grid;
use super::search::Search;
use super::slab::Slab;
use super::worker::{Tally, Worker};
use crate::aabb::Aabb;
use crate::parallel::Section;
use crate::real::Real;
use crate::tuning::kernel::{
    COMPARED_A_PAIR, EFFORT_SAMPLE, FAR_FEWER, GRID_TRIES, ONE_TUBE_UP_TO, QUERY, SECOND_SAMPLE,
    TREE_FROM, VISIT,
};
use crate::tuning::prices::SEARCHED;

/// The boxes of a size class, sorted into tubes.
#[derive(Clone, Debug, Default)]
pub(super) struct Class<R, const D: usize> {
    pub(super) grid: Grid<R>,
    /// How many boxes it has, and how many of its tubes have entries.
    count: usize,
    pub(super) tubes: usize,
    /// Together they cover the grid.
    pub(super) slabs: Vec<Slab<R, D>>,
    /// A box around those of the class, if its tubes are kept.
    pub(super) bounds: Option<Aabb<R, D>>,
}

impl<R: Real, const D: usize> Class<R, D> {
    /// Sorts the members into tubes, and appends their pairs. Replaces `oversized` by the members that are left to further classes, and by
    /// invalid ones. If there are crowded tubes, all of these leave the list of members.
    pub(super) fn search(
        &mut self,
        members: &mut Vec<u32>,
        oversized: &mut Vec<u32>,
        assignment: &mut Assignment,
        search: &mut Search<R, D>,
    ) {
        let boxes = search.boxes;
        self.assign(members, oversized, assignment, search);
        self.count = members.len() - oversized.len();
        if !search.is_last_class && assignment.leave_crowds(boxes, members, oversized) {
            self.count = members.len();
            assignment.assign(boxes, members, &self.grid, &mut Vec::new());
        }
        search.keeps |= !oversized.is_empty();
        let (kept, ranges) = (search.keeps.then_some(&self.grid), assignment.split());
        self.slabs.resize_with(ranges.len(), Slab::default);
        let section = Section::of(members.len(), SEARCHED);
        let slabs = self.slabs.iter_mut().zip(ranges);
        search.collect(section, slabs, |(slab, range), worker| {
            slab.range = range.clone();
            slab.sweep(boxes, assignment, kept, worker);
        });
        let tubes = self.slabs.iter().flat_map(|slab| &slab.tubes);
        self.tubes = tubes.clone().count();
        self.bounds = tubes.map(|tube| tube.bounds).reduce(|a, b| a.around(&b));
    }

    /// Chooses a grid and places the members in its tubes.
    ///
    /// A grid *fits* if the sweep takes few comparisons for each box and pair. Each try is counted, and the first grid that nearly fits is
    /// swept, because the boxes of its crowded tubes are left to further classes; if none does, the first one, unless a later one takes far
    /// fewer comparisons. Each class must take a fair share of the boxes, so that there are few classes. Where no grid does, and for the last
    /// class, one tube takes all boxes.
    fn assign(
        &mut self,
        members: &[u32],
        oversized: &mut Vec<u32>,
        assignment: &mut Assignment,
        search: &Search<R, D>,
    ) {
        let (boxes, count) = (search.boxes, members.len());
        let is_one_tube = search.is_last_class || count <= ONE_TUBE_UP_TO;
        let mut best = None;
        for aim in GRID_TRIES.into_iter().filter(|_| !is_one_tube) {
            if best.is_some() && aim.sample == SECOND_SAMPLE {
                break;
            }
            self.grid = Grid::choose(boxes, members, aim);
            assignment.assign(boxes, members, &self.grid, oversized);
            let taken = count - oversized.len();
            if taken <= count / 8 {
                continue;
            }
            let excess = excess(boxes, members, &self.grid, taken, assignment.comparisons());
            if excess <= FAR_FEWER {
                return;
            }
            if best.is_none_or(|(least, _)| excess < least / FAR_FEWER) {
                best = Some((excess, self.grid));
            }
        }
        self.grid = best.unwrap_or_default().1;
        assignment.assign(boxes, members, &self.grid, oversized);
    }

    /// Appends the pairs with a coarser class. A sample decides which class is looked up in the other, or that a segment tree finds the pairs.
    /// Queries that exceed their share of what the tree would take, and of a third more because samples mislead, are given up. The tree takes
    /// them, unless they are few.
    pub(super) fn meet(&self, coarse: &Self, search: &mut Search<R, D>) {
        let boxes = search.boxes;
        let run = |class: &Self, queries: &[u32], budget, search: &mut Search<R, D>| {
            search.run_queries(queries, budget, |i, worker| class.look_up(boxes, i, worker))
        };
        let count = self.count + coarse.count;
        let price = TREE_FROM * f64::from(count.max(1).ilog2()).powi(2) * count as f64;
        // If each of them reaches all tubes and boxes, they take a tenth of what the tree would.
        let are_few = |queries: &[u32], class: &Self| {
            queries.len() as f64 * (class.count + VISIT * class.tubes) as f64 <= price / 10.0
        };
        let (mut class, mut queries, mut members) = (self, coarse.members(), Vec::new());
        if !are_few(&queries, class) {
            members = self.members();
            let efforts = [(self, &queries), (coarse, &members)]
                .map(|(class, queries)| class.effort(queries, price, search));
            if efforts[1] < efforts[0] {
                class = coarse;
                std::mem::swap(&mut queries, &mut members);
            }
            if efforts[0].min(efforts[1]) <= price {
                let budget = (price / 0.75 / queries.len() as f64) as u64;
                queries = run(class, &queries, budget, search);
            }
        }
        match are_few(&queries, class) {
            true => _ = run(class, &queries, u64::MAX, search),
            false => search.match_lists(&queries, &members),
        }
    }

    /// The boxes of the class, in the order of its tubes.
    fn members(&self) -> Vec<u32> {
        let owners = self.slabs.iter().flat_map(Slab::kept_owners);
        let at_home = owners.filter(|owner| owner.is_at_home());
        at_home.map(|owner| owner.index()).collect()
    }

    /// An estimate of the comparisons for looking these boxes up in the class, besides some for each pair, by a sample. It takes at most a
    /// sixteenth of what the tree would.
    fn effort(&self, queries: &[u32], price: f64, search: &mut Search<R, D>) -> f64 {
        let mut pairs = Vec::new();
        let mut worker = Worker::new(&mut pairs, usize::MAX);
        worker.begin_task((price / 16.0) as u64);
        let (mut sample, mut sampled) = (sample_of(queries, EFFORT_SAMPLE), 0);
        while let Some(&i) = sample.next().filter(|_| !worker.is_budget_exceeded()) {
            self.look_up(search.boxes, i, &mut worker);
            sampled += 1;
        }
        let Tally { compared, emitted } = worker.finish();
        search.tally.compared += compared;
        let besides = compared.saturating_sub(COMPARED_A_PAIR * emitted as u64);
        (QUERY + besides as f64 / f64::from(sampled.max(1))) * queries.len() as f64
    }
}
