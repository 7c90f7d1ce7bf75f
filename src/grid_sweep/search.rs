//! A search: its input, its output, and how threads share its parts.

use super::worker::{Tally, Worker};
use crate::aabb::Aabb;
use crate::parallel::Section;
use crate::tuning::prices::LOOKED_UP;

/// Removes unwanted pairs from the given one on.
type Filter<'a> = &'a (dyn Fn(&mut Vec<[u32; 2]>, usize) + Sync);

/// The input and the output of a search, for all size classes.
pub(super) struct Search<'a, R, const D: usize> {
    pub(super) boxes: &'a [Aabb<R, D>],
    /// Whether the next class takes all boxes that are left.
    pub(super) is_last_class: bool,
    /// Whether tubes are kept: the caller will look boxes up, or there are several classes.
    pub(super) keeps: bool,
    pub(super) pairs: &'a mut Vec<[u32; 2]>,
    /// `None` means that all pairs are wanted.
    filter: Option<Filter<'a>>,
    /// How many pairs may overlap, wanted or not. If there are more, the search stops with some of them.
    most: usize,
    pub(super) tally: Tally,
}

impl<'a, R, const D: usize> Search<'a, R, D> {
    /// A search after which nothing is looked up.
    pub(super) fn new(
        boxes: &'a [Aabb<R, D>],
        filter: Option<Filter<'a>>,
        most: usize,
        pairs: &'a mut Vec<[u32; 2]>,
    ) -> Self {
        Self {
            boxes,
            is_last_class: false,
            keeps: false,
            pairs,
            filter,
            most,
            tally: Tally::default(),
        }
    }

    /// Whether more pairs overlap than may. The number of slabs makes no difference.
    pub(super) fn is_over(&self) -> bool {
        self.tally.emitted > self.most
    }

    /// Calls `find` with each part, on several threads if there are several parts, and appends the pairs in the order of the parts.
    /// Returns the parts.
    pub(super) fn collect<T: Send>(
        &mut self,
        section: Section,
        parts: impl IntoIterator<Item = T>,
        find: impl Fn(&mut T, &mut Worker) + Send + Sync,
    ) -> Vec<T> {
        let (most, filter) = (self.most.saturating_sub(self.tally.emitted), self.filter);
        // The pairs of the first part need not be copied.
        let mut found = std::mem::take(self.pairs);
        let parts = parts.into_iter();
        let parts = parts.map(|part| (part, std::mem::take(&mut found), Tally::default()));
        let mut parts: Vec<_> = parts.collect();
        section.for_each(&mut parts, |(part, pairs, tally)| {
            let start = pairs.len();
            let mut worker = Worker::new(pairs, most);
            find(part, &mut worker);
            *tally = worker.finish();
            if let Some(filter) = filter {
                filter(pairs, start);
            }
        });
        *self.pairs = found;
        for (_, pairs, tally) in &mut parts {
            self.tally.emitted += tally.emitted;
            self.tally.compared += tally.compared;
            match self.pairs.is_empty() {
                true => std::mem::swap(pairs, self.pairs),
                false => self.pairs.append(pairs),
            }
        }
        parts.into_iter().map(|(part, ..)| part).collect()
    }

    /// Calls `look_up` with each query, and appends the pairs in the order of the queries. Returns the queries that took more comparisons than
    /// the budget, besides some for each pair. Their pairs are not appended. Stops early if more pairs overlap than may.
    pub(super) fn run_queries(
        &mut self,
        queries: &[u32],
        budget: u64,
        look_up: impl Fn(u32, &mut Worker) + Sync,
    ) -> Vec<u32> {
        let section = Section::of(queries.len(), LOOKED_UP);
        let queries_a_part = queries.len().div_ceil(section.parts()).max(1);
        let parts = queries.chunks(queries_a_part).map(|part| (part, vec![]));
        let parts = self.collect(section, parts, |(queries, costly), worker| {
            for &query in *queries {
                worker.begin_task(budget);
                look_up(query, worker);
                if worker.is_over() {
                    break;
                }
                if worker.is_budget_exceeded() {
                    worker.take_back();
                    costly.push(query);
                }
            }
        });
        parts.into_iter().flat_map(|(_, costly)| costly).collect()
    }
}
