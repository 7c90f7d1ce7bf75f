//! The update cycle: what happens between one set of pairs and the next.
//!
//! 1. **Note.** Placing, clearing and removing proxies between two updates only writes boxes and takes notes: which slots were
//!    *touched*, and which of those have *left* their fat boxes.
//! 2. **Plan.** [`Plan::of`] looks at a few numbers (slots, touched, leavers, candidates, costs so far) and chooses one of
//!    four: nothing, compare, look up, or a full search. The same numbers give the same plan on every machine.
//! 3. **Inflate.** Boxes are inflated to fat boxes ahead of their motion, from the previous box to the present one: those of the
//!    leavers before a look-up, of all that were touched before a full search. A comparison needs none.
//! 4. **Search.** A look-up finds the new candidates of the leavers, by the layers; a full search finds all candidates. If a
//!    full search finds too many, foresight is shortened, and steps 3 and 4 are repeated with all boxes.
//! 5. **Compare.** Candidates of the leavers are retired, those of the other touched proxies are compared, and what was found
//!    is taken in; after a full search, what was found replaces all. Wherever the answer for a pair differs from what was held,
//!    a change is reported.
//! 6. **Commit.** The present boxes become the previous ones, and the notes are forgotten.
//!
//! The fat boxes that were not left stay as they are, and with them the candidates: that is what the next updates live on.

use super::candidates::Comparing;
use super::foresight::{Foresight, mean_speed};
use super::layers::TooMany;
use super::policy::{self, CompareMode, Cost, Plan, PlanInputs};
use super::{FilterKey, PairObserver, PairTracker};
use crate::real::Real;
use crate::stats::Work;
use crate::stopwatch::Phase;
use crate::tuning::prices::{COMPARED, PICKED, SLOT};
use crate::tuning::update::{FOUND_SPARE_ONE_IN, KEEP_SCRATCH_UP_TO, MOST_FOUND};

impl<R: Real, const D: usize, K: FilterKey> PairTracker<R, D, K> {
    /// Brings the pairs up to date and reports what has changed since the last call.
    ///
    /// Costs nothing when nothing was touched. Otherwise the candidates of the touched are compared, or, if most proxies
    /// were touched, all candidates in order. Each proxy that has left its fat box is looked up in about **O(log n)**; if
    /// there are many, there is a run of the kernel over all proxies instead.
    ///
    /// If volumes are in use, a held pair ends when one of its boxes is renewed and they are farther apart than `slack`, unless the
    /// observer says that it is active.
    pub(crate) fn finish(&mut self, slack: R, observer: &mut impl PairObserver) {
        self.stopwatch.enter(Phase::Difference);
        let notes = &self.proxies.notes;
        if !(notes.touched.is_empty() && notes.revolumed.is_empty()) {
            self.candidates.compact_if_sparse();
            self.proxies.begin_finish(slack);
        }
        let proxies = &self.proxies;
        let plan = Plan::of(&self.plan_inputs(), || {
            mean_speed(proxies.touched(), &proxies.boxes, &proxies.previous)
        });
        match plan {
            Plan::Nothing => {
                self.stopwatch.leave();
                return;
            }
            Plan::Compare(mode) => {
                self.work = Work::default();
                self.found.clear();
                self.compare(mode, observer);
            }
            Plan::LookUp(mode) => match self.look_up() {
                Ok(()) => self.compare(mode, observer),
                Err(TooMany) => {
                    self.foresight.shorten();
                    self.cost = Cost::default();
                    self.search_in_full(self.foresight, observer);
                }
            },
            Plan::FullSearch(foresight) => {
                self.cost = Cost::default();
                self.search_in_full(foresight, observer);
            }
        }
        self.cost.add(&self.work);
        self.proxies.commit();
        self.stopwatch.leave();
    }

    /// About how much work there will be if so many slots are touched, going by the mean of the updates since the last full search.
    pub(crate) fn work_ahead(&self, touched: usize) -> u64 {
        if touched == 0 {
            return 0;
        }
        let mean = self.cost.searching / self.cost.updates.max(1);
        let comparing = match policy::are_most_touched(touched, self.proxies.len()) {
            true => COMPARED * self.candidates.rows() as u64 + SLOT * self.proxies.len() as u64,
            false => PICKED * self.candidates.rows() as u64,
        };
        mean.saturating_add(self.proxies.volumes.price(comparing))
    }

    fn plan_inputs(&self) -> PlanInputs {
        PlanInputs {
            slots: self.proxies.len(),
            touched: self.proxies.notes.touched.len(),
            revolumed: self.proxies.notes.revolumed.len(),
            leavers: self.proxies.leavers.len(),
            candidates: self.candidates.len(),
            rows: self.candidates.rows(),
            lists: self.candidates.lists.state,
            above_base: self.layers.above_base(),
            foresight: self.foresight,
            cost: self.cost,
        }
    }

    /// Inflates the leavers anew and looks them up among all others.
    fn look_up(&mut self) -> Result<(), TooMany> {
        self.proxies.inflate_leavers(self.foresight);
        self.found.clear();
        let (proxies, most) = (&self.proxies, self.most_found());
        self.work = self.layers.find_leavers(
            &proxies.fat_boxes,
            &proxies.leavers,
            |pair| !proxies.are_filtered || proxies.may_meet(pair),
            most,
            &mut self.found,
            &mut self.stopwatch,
        )?;
        self.stopwatch.enter(Phase::Difference);
        Ok(())
    }

    /// Compares candidates, retires those of the leavers, and takes in what was found for these.
    fn compare(&mut self, mode: CompareMode, observer: &mut impl PairObserver) {
        let notes = &self.proxies.notes;
        let mut comparing = Comparing {
            candidates: &mut self.candidates,
            proxies: &self.proxies,
            observer,
        };
        let is_any_touched = !notes.touched.is_empty();
        if is_any_touched {
            comparing.compare(mode, &mut self.work);
        }
        let are_all_compared = is_any_touched && mode == CompareMode::All;
        if !(notes.revolumed.is_empty() || are_all_compared) {
            comparing.compare_volumes();
        }
        comparing.extend(&mut self.found);
        if !self.foresight.is_fixed && self.are_too_many(self.candidates.len()) {
            self.foresight.shorten();
            self.layers.forget();
        }
    }

    /// Searches for all candidates, by fat boxes with this foresight.
    fn search_in_full(&mut self, foresight: Foresight, observer: &mut impl PairObserver) {
        // What was read from a snapshot may be any number.
        self.full_searches = self.full_searches.wrapping_add(1);
        self.foresight = foresight;
        self.work = Work::default();
        self.proxies.inflate_touched(self.foresight);
        self.found.clear();
        let count = self.candidates.len();
        self.found.reserve_exact(count + count / FOUND_SPARE_ONE_IN);
        let mut most = self.most_found();
        while self.search(most).is_err() || self.are_too_many_found(most) {
            self.foresight.shorten();
            self.proxies.inflate_all(self.foresight);
            self.found = Vec::new();
            // Only now: even without foresight, what has not moved since may have had its fat box from an earlier time.
            if self.foresight.moves == 0 {
                most = usize::MAX;
            }
        }
        let mut comparing = Comparing {
            candidates: &mut self.candidates,
            proxies: &self.proxies,
            observer,
        };
        comparing.replace(&mut self.found);
        let near = self.candidates.overlapping_count - self.candidates.held_count;
        self.proxies.volumes.reset_odometers(near);
        if self.found.capacity() > KEEP_SCRATCH_UP_TO {
            self.found = Vec::new();
        }
    }

    /// Appends the pairs that may meet among all fat boxes that overlap to what was found. Gives up when far more than `most` overlap.
    fn search(&mut self, most: usize) -> Result<(), TooMany> {
        let proxies = &self.proxies;
        let may_meet = |pair| proxies.may_meet(pair);
        let overlapping = self.layers.find_all(
            &proxies.fat_boxes,
            proxies.are_filtered.then_some(may_meet),
            most,
            &mut self.found,
            &mut self.stopwatch,
        );
        self.stopwatch.enter(Phase::Difference);
        self.work.searched += proxies.len();
        self.work.found += overlapping?;
        Ok(())
    }

    /// How many more pairs of fat boxes than last time a search may find before it gives up.
    fn most_found(&self) -> usize {
        match self.foresight.is_fixed {
            true => usize::MAX,
            false => MOST_FOUND * (self.proxies.len() + self.candidates.overlapping_count),
        }
    }

    /// Whether this number of candidates is more than foresight can be worth.
    fn are_too_many(&self, candidates: usize) -> bool {
        let overlapping = self.candidates.overlapping_count;
        policy::are_too_many(candidates, self.proxies.len(), overlapping)
    }

    /// Whether too many candidates were found, if there is a limit. How many of them overlap is not known yet.
    fn are_too_many_found(&self, most: usize) -> bool {
        // There are hardly ever that many, so boxes are hardly ever compared here.
        most < usize::MAX && self.are_too_many(self.found.len()) && {
            let overlapping = self.found.iter();
            let overlapping = overlapping.filter(|&&pair| self.proxies.overlap(pair));
            policy::are_too_many(self.found.len(), self.proxies.len(), overlapping.count())
        }
    }
}
