//! The update cycle: what happens between one set of pairs and the next.
//!
//! 1. **Touched.** Placing, refusing and removing proxies between two updates only writes boxes and takes notes: which slots
//!    were *touched*, and which of those have *escaped*, because the new box is no longer inside the fat box. Nothing is
//!    searched or compared yet, so a proxy may be touched any number of times.
//! 2. **Plan.** [`Plan::of`] looks at a few numbers (slots, touched, escaped, candidates, costs so far) and chooses one of
//!    four: nothing, compare, look up, or a full run. The same numbers give the same plan on every machine.
//! 3. **Draw.** Fat boxes are drawn ahead of the motion from the previous box to the present one: those of the escaped
//!    before a look-up, those of all that were touched before a full run. A comparison draws none.
//! 4. **Search.** A look-up finds the new candidates of the escaped, by the layers; a full run finds all candidates. If a
//!    full run finds too many, foresight is shortened, and steps 3 and 4 are repeated with all fat boxes.
//! 5. **Compare.** Candidates of the escaped are retired, those of the other touched proxies are compared, and what was found
//!    is taken in; after a full run, what was found replaces all. Wherever the answer for a pair differs from what was held,
//!    a change is reported.
//! 6. **Settle.** The present boxes become the previous ones, and the touched the last touched.
//!
//! The fat boxes of proxies that did not escape stay as they are, and with them the candidates: that is what the next updates
//! live on.

use super::candidates::Proxies;
use super::foresight::Foresight;
use super::horizon::mean_speed;
use super::layers::retain_from;
use super::policy::{self, Extent, Known, Plan, Spent, are_most_touched};
use super::{FilterKey, PairChange, PairTracker};
use crate::stopwatch::Phase;
use crate::tuning::update::{FOUND_SPARE_ONE_IN, KEEP_SCRATCH_UP_TO, SLOTS_A_TASK, THREADS_FROM};
use crate::{Real, Work, parallel};

impl<R: Real, const D: usize, K: FilterKey> PairTracker<R, D, K> {
    /// Brings the pairs up to date and reports what has changed since the last call.
    ///
    /// Costs nothing when nothing was touched. Otherwise the candidates of the touched are compared, or, if most proxies
    /// were touched, all candidates in order. Each proxy that has left its fat box is looked up in about **O(log n)**; if
    /// there are many, there is a run of the kernel over all proxies instead.
    ///
    /// If volumes are in use, a held pair ends when one of its boxes is renewed and they are farther apart than `slack`.
    pub(crate) fn finish(&mut self, slack: R, mut report: impl FnMut(PairChange)) {
        self.stopwatch.enter(Phase::Difference);
        self.slack = slack;
        if !(self.touched.is_empty() && self.stirred.is_empty()) {
            self.candidates.compact_if_sparse();
            // Stable: of several keys that a slot has had in this update, the first one is kept.
            self.former_keys.sort_by_key(|&(slot, _)| slot);
            self.former_keys.dedup_by_key(|&mut (slot, _)| slot);
            self.mark_renewed();
        }
        let plan = Plan::of(&self.known(), || {
            mean_speed(&self.touched, &self.boxes, &self.previous)
        });
        match plan {
            Plan::Nothing => {
                self.last_touched.clear();
                self.stopwatch.leave();
                return;
            }
            Plan::Compare(extent) => {
                self.work = Work::default();
                self.found.clear();
                self.compare(extent, &mut report);
            }
            Plan::LookUp(extent) => {
                self.look_up();
                self.compare(extent, &mut report);
            }
            Plan::FullRun(foresight) => {
                self.spent = Spent::default();
                self.run_in_full(foresight, &mut report);
            }
        }
        self.spent.add(&self.work);
        self.settle();
        self.stopwatch.leave();
    }

    /// Marks the slots that have another box, if volumes are in use.
    fn mark_renewed(&mut self) {
        if !self.volumes.are_used() {
            return;
        }
        self.renewed.resize(self.boxes.len());
        for &slot in &self.touched {
            let i = slot as usize;
            if self.boxes[i] != self.previous[i] {
                self.renewed.insert(i);
            }
        }
    }

    /// What decides the plan.
    fn known(&self) -> Known {
        Known {
            slots: self.boxes.len(),
            touched: self.touched.len(),
            stirred: self.stirred.len(),
            escaped: self.escaped.len(),
            candidates: self.candidates.len(),
            rows: self.candidates.rows(),
            lists: self.candidates.lists(),
            are_layers_used: self.layers.are_used(),
            above_base: self.layers.above_base(),
            foresight: self.foresight,
            spent: self.spent,
        }
    }

    /// Draws the fat boxes of the escaped anew and looks them up among all others.
    fn look_up(&mut self) {
        self.draw_escaped();
        self.found.clear();
        let Self {
            layers,
            fat_boxes,
            escaped,
            found,
            work,
            stopwatch,
            ..
        } = self;
        *work = layers.find_escaped(fat_boxes, escaped, found, stopwatch);
        self.stopwatch.enter(Phase::Difference);
        self.keep_those_that_may_meet();
    }

    /// Compares candidates, retires the candidates of the escaped, and takes in what was found for the escaped.
    fn compare(&mut self, extent: Extent, report: &mut impl FnMut(PairChange)) {
        let proxies = Proxies {
            now: &self.boxes,
            before: &self.previous,
            keys: &self.keys,
            former_keys: &self.former_keys,
            volumes: &self.volumes,
            renewed: &self.renewed,
            slack: self.slack,
        };
        let (mut comparing, mut are_all_compared) = (Work::default(), false);
        if !self.touched.is_empty() {
            let (touched, escaped) = (&self.touched, &self.escaped);
            comparing = self
                .candidates
                .compare(extent, touched, escaped, &proxies, report);
            are_all_compared = extent == Extent::All;
        }
        if !(self.stirred.is_empty() || are_all_compared) {
            self.candidates
                .compare_stirred(&self.stirred, &proxies, report);
        }
        self.work = Work {
            compared: comparing.compared,
            picked: comparing.picked,
            walked: comparing.walked,
            ..self.work
        };
        self.candidates.extend(&self.found, &proxies, report);
        if !self.foresight.is_fixed() && self.are_too_many(self.candidates.len()) {
            self.foresight.shorten();
            self.layers.forget();
        }
    }

    /// Searches for all candidates, by fat boxes that are drawn with this foresight.
    fn run_in_full(&mut self, foresight: Foresight, report: &mut impl FnMut(PairChange)) {
        // What was read from a snapshot may be any number.
        self.full_runs = self.full_runs.wrapping_add(1);
        self.foresight = foresight;
        self.work = Work::default();
        self.draw_touched();
        self.found.clear();
        let count = self.candidates.len();
        self.found.reserve_exact(count + count / FOUND_SPARE_ONE_IN);
        self.search();
        while !self.foresight.is_fixed() && self.are_too_many_found() {
            self.foresight.shorten();
            self.draw_all();
            self.found = Vec::new();
            self.search();
            // Also if there was no foresight before: what has not moved since may have its fat box from an earlier time.
            if !self.foresight.is_any() {
                break;
            }
        }
        let proxies = Proxies {
            now: &self.boxes,
            before: &self.previous,
            keys: &self.keys,
            former_keys: &self.former_keys,
            volumes: &self.volumes,
            renewed: &self.renewed,
            slack: self.slack,
        };
        self.candidates.replace(&mut self.found, &proxies, report);
        if self.found.capacity() > KEEP_SCRATCH_UP_TO {
            self.found = Vec::new();
        }
    }

    /// Appends the overlapping pairs among all fat boxes to what was found.
    fn search(&mut self) {
        self.layers
            .find_all(&self.fat_boxes, &mut self.found, &mut self.stopwatch);
        self.work.searched += self.boxes.len();
        self.work.found += self.found.len();
        self.stopwatch.enter(Phase::Difference);
        self.keep_those_that_may_meet();
    }

    /// Drops the found pairs that may not meet.
    fn keep_those_that_may_meet(&mut self) {
        if self.are_filtered {
            let keys = &self.keys;
            retain_from(&mut self.found, 0, |[a, b]| {
                keys[a as usize].may_meet(keys[b as usize])
            });
        }
    }

    /// Whether this number of candidates is more than foresight can be worth.
    fn are_too_many(&self, candidates: usize) -> bool {
        policy::are_too_many(
            candidates,
            self.boxes.len(),
            self.candidates.overlapping_count(),
        )
    }

    /// Whether too many candidates were found. How many of them overlap is not known yet.
    fn are_too_many_found(&self) -> bool {
        let overlap =
            |&&[a, b]: &&[u32; 2]| self.boxes[a as usize].overlaps(&self.boxes[b as usize]);
        // There are hardly ever that many, so boxes are hardly ever compared here.
        self.are_too_many(self.found.len()) && {
            let overlapping = self.found.iter().filter(overlap).count();
            policy::are_too_many(self.found.len(), self.boxes.len(), overlapping)
        }
    }

    /// Makes the present boxes the previous ones.
    fn settle(&mut self) {
        if !are_most_touched(self.touched.len(), self.boxes.len()) {
            for &slot in &self.touched {
                self.previous[slot as usize] = self.boxes[slot as usize];
            }
        } else if self.boxes.len() < THREADS_FROM {
            self.previous.copy_from_slice(&self.boxes);
        } else {
            let boxes = self.boxes.chunks(SLOTS_A_TASK);
            let mut parts: Vec<_> = self.previous.chunks_mut(SLOTS_A_TASK).zip(boxes).collect();
            parallel::for_each(&mut parts, |(previous, boxes)| {
                previous.copy_from_slice(boxes)
            });
        }
        if self.volumes.are_used() {
            self.renewed.clear_around(&self.touched);
        }
        std::mem::swap(&mut self.touched, &mut self.last_touched);
        self.touched.clear();
        self.stirred.clear();
        self.escaped.clear();
        self.former_keys.clear();
    }
}
