//! The update cycle: from one set of pairs to the next.
//!
//! 1. **Note.** Between two updates, placing, clearing and removing proxies only writes boxes and keys, and takes notes: which slots were
//!    *touched*, which of those must be searched for again, and which have another volume, or a stale one that a pair asks for. The update
//!    begins by reading these volumes.
//! 2. **Plan.** Without leavers, it compares. Otherwise [`Cost::is_full_search_due`] looks at a few numbers (slots, leavers, candidates,
//!    costs so far) and chooses between a look-up and a full search. The same numbers give the same plan on every machine.
//! 3. **Inflate.** New fat boxes are made ahead of the motion from the previous box to the present one: for the leavers before a look-up,
//!    for all touched proxies before a full search. A comparison needs none.
//! 4. **Search.** A look-up finds the new candidates of the leavers, in the layers. A full search finds all candidates; if it finds too
//!    many, foresight is shortened, and steps 3 and 4 are repeated with all boxes.
//! 5. **Compare.** The candidates of the leavers are retired, those of the other touched proxies are compared, and those that were found
//!    are added; after a full search, those that were found replace all. Each pair that begins or ends is reported.
//! 6. **End.** The present boxes become the previous ones, and the notes are cleared.
//!
//! All other fat boxes stay, and with them their candidates. The next updates live on these.

use super::candidates::Comparing;
use super::foresight::{Foresight, mean_speed};
use super::layers::TooMany;
use super::policy::{Cost, Work, are_many_touched};
use super::{Changes, Colliders, FilterKey, PairTracker};
use crate::real::Real;
use crate::tuning::prices::{COMPARED, PICKED, SLOT};
use crate::tuning::update::KEEP_SCRATCH_UP_TO;

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
    /// most proxies were touched. Each proxy that has left its fat box is looked up in about **O(log n)**; if there are many, the kernel
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
        if self.proxies.notes.are_empty() {
            return;
        }
        self.proxies.begin_update(slack, colliders);
        self.work = Work::default();
        let proxies = &self.proxies;
        let recent = self.layers.recent();
        let counts = [proxies.leavers.len(), proxies.len(), self.candidates.len()];
        if counts[0] == 0 {
            self.compare(changes, colliders);
        } else if recent.is_none_or(|recent| self.cost.is_full_search_due(recent, counts)) {
            let speed = || mean_speed(&proxies.notes.touched, &proxies.boxes, &proxies.previous);
            let foresight = self.foresight.renewed(speed);
            self.search_in_full(foresight, changes, colliders);
        } else if self.look_up_leavers().is_ok() {
            self.compare(changes, colliders);
        } else {
            self.foresight.shorten();
            self.search_in_full(self.foresight, changes, colliders);
        }
        self.cost.add(&self.work);
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

    /// Makes new fat boxes for the leavers and looks them up among all others.
    fn look_up_leavers(&mut self) -> Result<(), TooMany> {
        self.proxies.inflate_leavers(self.foresight);
        let (proxies, most) = (&self.proxies, self.most_found());
        self.work = self.layers.find_pairs_of_leavers(
            &proxies.fat_boxes,
            &proxies.leavers,
            |pair| !proxies.are_filtered || proxies.may_meet(pair),
            most,
        )?;
        Ok(())
    }

    /// Compares candidates, retires those of the leavers, and adds those that were found.
    fn compare(&mut self, changes: &mut Changes, colliders: &impl Colliders<R, D>) {
        let mut comparing = Comparing {
            candidates: &mut self.candidates,
            proxies: &mut self.proxies,
            changes,
            colliders,
        };
        comparing.compare();
        comparing.extend(&mut self.layers.found);
        let overlapping = self.candidates.overlapping_count;
        if self.are_too_many(self.candidates.len(), overlapping) {
            self.foresight.shorten();
            self.layers.forget();
        }
    }

    /// Searches for all candidates, by fat boxes with this foresight.
    fn search_in_full(
        &mut self,
        foresight: Foresight,
        changes: &mut Changes,
        colliders: &impl Colliders<R, D>,
    ) {
        // A snapshot may hold any number.
        self.full_searches = self.full_searches.wrapping_add(1);
        self.foresight = foresight;
        self.cost = Cost::default();
        self.work = Work::default();
        self.proxies.inflate_touched(self.foresight);
        self.layers.found.clear();
        let count = self.candidates.len();
        let room = count + count / FOUND_SPARE_ONE_IN;
        self.layers.found.reserve_exact(room);
        let mut most = self.most_found();
        while self.search(most).is_err() || self.are_too_many_found(most) {
            self.foresight.shorten();
            self.proxies.inflate_all(self.foresight);
            self.layers.found = Vec::new();
            // Only now: the fat boxes of proxies that have not moved since may be from a time when there was foresight.
            if self.foresight.moves == 0 {
                most = usize::MAX;
            }
        }
        let mut comparing = Comparing {
            candidates: &mut self.candidates,
            proxies: &mut self.proxies,
            changes,
            colliders,
        };
        comparing.replace(&mut self.layers.found);
        if self.layers.found.capacity() > KEEP_SCRATCH_UP_TO {
            self.layers.found = Vec::new();
        }
    }

    /// Finds the pairs that may meet among all fat boxes that overlap.
    ///
    /// # Errors
    /// If so many more overlap than in the last full search as `most` says.
    fn search(&mut self, most: usize) -> Result<(), TooMany> {
        let proxies = &self.proxies;
        let may_meet = |pair| proxies.may_meet(pair);
        let overlapping = self.layers.find_all(
            &proxies.fat_boxes,
            proxies.are_filtered.then_some(may_meet),
            |slot| proxies.keys[slot as usize].clique(),
            most,
        );
        self.work.searched += proxies.len();
        self.work.found += overlapping?;
        Ok(())
    }

    /// How many more pairs of fat boxes than in the last full search a search may find before it gives up.
    fn most_found(&self) -> usize {
        MOST_FOUND * (self.proxies.len() + self.candidates.overlapping_count)
    }

    /// Whether there are more candidates than foresight can be worth, given how many of their boxes overlap.
    fn are_too_many(&self, candidates: usize, overlapping: usize) -> bool {
        candidates / MOST_CANDIDATES > self.proxies.len() + overlapping
    }

    /// Whether a search has found too many candidates, if there is a limit. How many of their boxes overlap is not known yet.
    fn are_too_many_found(&self, most: usize) -> bool {
        let (found, before) = (&self.layers.found, self.candidates.overlapping_count);
        let overlapping = found.iter().filter(|&&pair| self.proxies.overlap(pair));
        // There are hardly ever that many, so boxes are hardly ever compared here.
        most < usize::MAX
            && self.are_too_many(found.len(), before)
            && self.are_too_many(found.len(), overlapping.count())
    }
}
