//! What one thread does of a search: it sweeps tubes or looks queries up, one task after the other, and counts the work.

use super::emitter::Emitter;
use crate::tuning::kernel::COMPARED_A_PAIR;

/// The work of a search.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tally {
    /// Pairs that overlap, wanted or not.
    pub(crate) emitted: usize,
    /// Comparisons of two boxes, also those of a sweep that was given up, and visits of tubes in units of comparisons. With vectors, eight
    /// boxes count even if fewer are left.
    pub(crate) compared: usize,
}

/// The pairs of a thread, and the comparisons that it makes for them.
pub(super) struct Worker<'a> {
    pub(super) pairs: Emitter<'a>,
    pub(super) compared: usize,
    /// The most comparisons by the end of the present task, besides some for each of its pairs.
    budget: usize,
    /// The pairs before the present task.
    before_task: usize,
}

impl<'a> Worker<'a> {
    /// Appends at most so many pairs to the list.
    pub(super) fn new(pairs: &'a mut Vec<[u32; 2]>, most: usize) -> Self {
        Self {
            pairs: Emitter::new(pairs, most),
            compared: 0,
            budget: usize::MAX,
            before_task: 0,
        }
    }

    /// Begins a task, with this many comparisons besides some for each of its pairs.
    pub(super) fn begin_task(&mut self, budget: usize) {
        self.before_task = self.pairs.count();
        self.budget = self.compared.saturating_add(budget);
    }

    /// Whether the task has taken more comparisons than it may, or more pairs were emitted than may be appended. Then the task must end.
    #[inline(always)]
    pub(super) fn is_budget_exceeded(&self) -> bool {
        let pairs = self.pairs.count() - self.before_task;
        let for_pairs = COMPARED_A_PAIR.saturating_mul(pairs);
        self.compared >= self.budget.saturating_add(for_pairs) || self.pairs.is_over()
    }

    /// Takes the pairs of the task back, unless more were emitted than may be appended.
    pub(super) fn take_back(&mut self) {
        self.pairs.take_back(self.before_task);
    }

    /// Appends the rest of the pairs, and returns the work of all tasks.
    pub(super) fn finish(mut self) -> Tally {
        self.pairs.flush();
        Tally {
            emitted: self.pairs.count(),
            compared: self.compared,
        }
    }
}
