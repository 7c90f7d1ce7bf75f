//! The update cycle: from one set of pairs to the next.
//!
//! ARCHITECTURE.md has its steps as a table. Fat boxes that nobody has left stay, and with them their candidates. The next updates live on these.

use super::candidates::Comparing;
use super::foresight::mean_speed;
use super::policy::{Work, are_many_touched};
use super::{Changes, Colliders, FilterKey, PairTracker};
use crate::real::Real;
use crate::tuning::prices::{COMPARED, PICKED, SLOT};

/// One candidate in this many. A full search reserves room for so many more than there are. If larger: the list of pairs grows during the
/// search, and is copied. If smaller: memory.
const FOUND_SPARE_ONE_IN: usize = 8;

/// Pairs of fat boxes for each slot and pair of overlapping boxes. A search that finds so many more than the last one is given up, and
/// foresight is cut. If larger: memory. If smaller: a crowd of new boxes is searched twice.
const MOST_FOUND: usize = 64;

/// Candidates for each slot and pair of overlapping boxes. With more, foresight is cut, for example where huge boxes are about to pass over
/// many small ones. If larger: memory. If smaller: dense scenes lose their foresight.
const MOST_CANDIDATES: usize = 8;

impl<R: Real, const D: usize, K: FilterKey> PairTracker<R, D, K> {
    /// Brings the pairs up to date and reports what has changed since the last call.
    ///
    /// Takes no time if nothing was written. Otherwise it compares the candidates of the touched proxies, or all candidates in order if
    /// a third of all proxies or more were touched. Each proxy that has left its fat box is looked up in about **O(log n)**; if there are many, the kernel
    /// searches among all proxies instead.
    ///
    /// If volumes are in use, a held pair ends when one of its boxes is renewed and its volumes are farther apart than `slack`, unless its
    /// contact is active.
    pub(crate) fn update(
        &mut self,
        slack: R,
        changes: &mut Changes,
        colliders: &impl Colliders<R, D>,
    ) {
        let notes = &self.proxies.notes;
        if notes.touched.is_empty() && notes.revolumed.is_empty() {
            return;
        }
        self.proxies.begin_update(slack, colliders);
        let (proxies, candidates) = (&self.proxies, &self.candidates);
        let counts = [proxies.leavers.len(), proxies.len(), candidates.len()];
        let mut found = Vec::new();
        let looked_up = match self.layers.recent() {
            _ if counts[0] == 0 => Some(Work::default()),
            Some(recent) if !self.cost.is_full_search_due(recent, counts) => {
                self.look_up_leavers(&mut found)
            }
            _ => {
                let moved = &proxies.notes.touched;
                let speed = || mean_speed(moved, &proxies.boxes, &proxies.previous);
                self.foresight = self.foresight.renewed(speed);
                None
            }
        };
        let is_full = looked_up.is_none();
        let work = looked_up.unwrap_or_else(|| self.search_in_full(&mut found));
        let mut comparing = Comparing {
            candidates: &mut self.candidates,
            proxies: &mut self.proxies,
            changes,
            colliders,
        };
        if is_full {
            comparing.replace(found);
        } else {
            comparing.compare();
            comparing.extend(found);
            let overlapping = self.candidates.overlapping_count;
            if self.are_too_many(self.candidates.len(), overlapping) {
                self.foresight.shorten();
                self.layers.is_base_sorted = false;
            }
        }
        self.cost.add(&work);
        self.proxies.end_update();
    }

    /// An estimate of the work of the next update if so many slots are touched, from the mean of the updates since the last full search.
    pub(crate) fn work_ahead(&self, touched: usize) -> u64 {
        if touched == 0 {
            return 0;
        }
        let comparing = match are_many_touched(touched, self.proxies.len()) {
            true => COMPARED * self.candidates.len() as u64 + SLOT * self.proxies.len() as u64,
            false => PICKED * self.candidates.first_cold as u64,
        };
        let comparing = self.proxies.volumes.price(comparing);
        self.cost.mean().saturating_add(comparing)
    }

    /// Makes new fat boxes for the leavers and finds their candidates among all others. `None` if there are too many; then foresight is
    /// shortened.
    fn look_up_leavers(&mut self, found: &mut Vec<[u32; 2]>) -> Option<Work> {
        self.proxies.inflate_leavers(self.foresight);
        let (proxies, most) = (&self.proxies, self.most_found());
        let looked_up = self.layers.find_pairs_of_leavers(
            &proxies.fat_boxes,
            &proxies.leavers,
            |pair| !proxies.are_filtered || proxies.may_meet(pair),
            most,
            found,
        );
        if looked_up.is_none() {
            self.foresight.shorten();
        }
        looked_up
    }

    /// Finds all candidates, by fat boxes with the present foresight, or with a shorter one if there are too many.
    fn search_in_full(&mut self, found: &mut Vec<[u32; 2]>) -> Work {
        // A snapshot may hold any number.
        self.full_searches = self.full_searches.wrapping_add(1);
        self.cost = Work::default();
        let (mut work, mut most) = (Work::default(), self.most_found());
        self.proxies.inflate(self.foresight, false);
        let count = self.candidates.len();
        *found = Vec::with_capacity(count + count / FOUND_SPARE_ONE_IN);
        loop {
            let proxies = &self.proxies;
            let may_meet = |pair| proxies.may_meet(pair);
            let overlapping = self.layers.find_all(
                &proxies.fat_boxes,
                proxies.are_filtered.then_some(may_meet),
                |slot| proxies.keys[slot as usize].clique(),
                most,
                found,
            );
            work.searched += proxies.len() as u64;
            work.found += overlapping.unwrap_or(0) as u64;
            if overlapping.is_some() && !self.are_too_many_found(found, most) {
                return work;
            }
            self.foresight.shorten();
            self.proxies.inflate(self.foresight, true);
            *found = Vec::new();
            // Only now: the fat boxes of proxies that have not moved since may be from a time when there was foresight.
            if self.foresight.moves == 0 {
                most = usize::MAX;
            }
        }
    }

    /// How many more pairs of fat boxes than in the last full search a search may find before it gives up.
    fn most_found(&self) -> usize {
        MOST_FOUND.saturating_mul(self.proxies.len() + self.candidates.overlapping_count)
    }

    /// Whether there are more candidates than foresight can be worth, given how many of their boxes overlap.
    fn are_too_many(&self, candidates: usize, overlapping: usize) -> bool {
        candidates / MOST_CANDIDATES > self.proxies.len() + overlapping
    }

    /// Whether a search has found too many candidates, if there is a limit. How many of their boxes overlap is not known yet.
    fn are_too_many_found(&self, found: &[[u32; 2]], most: usize) -> bool {
        let before = self.candidates.overlapping_count;
        let overlapping = found.iter().filter(|&&pair| self.proxies.overlap(pair));
        // There are hardly ever that many, so boxes are hardly ever compared here.
        most < usize::MAX
            && self.are_too_many(found.len(), before)
            && self.are_too_many(found.len(), overlapping.count())
    }
}
