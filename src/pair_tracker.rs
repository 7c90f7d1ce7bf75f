//! The pair set over time: proxies in, changes of the pair set out.
//!
//! A *proxy* is a box kept under a slot number. Between two calls of [`PairTracker::finish`] proxies are
//! placed, moved and removed; `finish` then reports how the set of overlapping pairs has changed.
//!
//! Each proxy has a fat box around its box. The pairs whose fat boxes overlap are the candidates, and only when
//! proxies leave their fat boxes must there be a search for new ones. In between, each candidate is held or not, as its
//! two boxes overlap or not. Held pairs whose candidates are retired are kept in a hash table until it is known whether they are found
//! again. This is the neighbour list of molecular dynamics (Verlet 1967), made exact.

mod box_update;
mod candidates;
mod chunk;
mod foresight;
mod layers;
mod odometer;
mod policy;
mod proxies;
#[cfg(feature = "serde-serialize")]
mod snapshot;
#[cfg(test)]
mod tests;
mod update;
mod validation;
mod volumes;

use std::fmt::Debug;

use crate::grid_sweep::MAX_BOXES;
use crate::kernel::Kernel;
use crate::real::Real;
use crate::stats::{Stats, Work};
use crate::stopwatch::Stopwatch;
pub(crate) use box_update::BoxUpdate;
use candidates::Candidates;
pub(crate) use chunk::ProxyChunk;
use foresight::Foresight;
use layers::Layers;
use policy::Cost;
pub(crate) use proxies::{Notes, Proxies};
#[cfg(feature = "serde-serialize")]
pub(crate) use snapshot::TrackerSnapshot;
pub(crate) use volumes::VolumeUpdate;

/// The most slots that there may be: every kernel takes so many boxes.
pub(crate) const MOST_SLOTS: usize = MAX_BOXES;

/// A change of the pair set, by slots, smaller first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PairChange {
    Added([u32; 2]),
    Deleted([u32; 2]),
}

/// Whom an update tells how the pair set changes, and asks about pairs.
pub(crate) trait PairObserver: Sync {
    fn report(&mut self, change: PairChange);

    /// Whether the contact of a held pair is active, so that the pair must not end while its boxes overlap: whoever removes an active
    /// contact wakes its bodies.
    fn is_active(&self, _pair: [u32; 2]) -> bool {
        false
    }
}

impl<F: FnMut(PairChange) + Sync> PairObserver for F {
    fn report(&mut self, change: PairChange) {
        self(change);
    }
}

/// What decides, with the boxes, whether two proxies may become a pair. A pair that its keys come to forbid stays until its boxes part.
pub(crate) trait FilterKey: Copy + Debug + Default + PartialEq + Send + Sync {
    /// Whether the two may be a pair; the same in either order.
    fn may_meet(self, other: Self) -> bool;

    /// Whether the two, if they meet, would touch, and not only intersect; the same in either order.
    fn may_touch(self, _other: Self) -> bool {
        true
    }

    /// Whether a proxy whose key has changed from `former` to this one gets a new box, without a margin.
    fn renews_box(self, _former: Self) -> bool {
        false
    }
}

/// The proxies and the pairs they form.
#[derive(Clone, Debug)]
pub(crate) struct PairTracker<R: Real, const D: usize, K> {
    pub(crate) proxies: Proxies<R, D, K>,
    foresight: Foresight,
    /// What the last update took.
    work: Work,
    /// What searching has cost since the last full search, that run included.
    cost: Cost,
    full_searches: u64,
    candidates: Candidates,
    layers: Layers<R, D>,
    /// Scratch: the candidates found by the kernel.
    found: Vec<[u32; 2]>,
    pub(crate) stopwatch: Stopwatch,
}

impl<R: Real, const D: usize, K: FilterKey> PairTracker<R, D, K> {
    /// A tracker without proxies. `foresight` fixes for how many moves ahead it searches; without `layers`, every search
    /// is for all pairs. With `volumes`, pairs whose boxes overlap are told apart by their volumes.
    pub(crate) fn new(kernel: Kernel, layers: bool, foresight: Option<u16>, volumes: bool) -> Self {
        Self {
            proxies: Proxies::new(volumes),
            foresight: Foresight::new(foresight),
            work: Work::default(),
            cost: Cost::default(),
            full_searches: 0,
            candidates: Candidates::default(),
            layers: Layers::new(kernel, layers),
            found: Vec::new(),
            stopwatch: Stopwatch::default(),
        }
    }

    /// The held pairs, by slots, smaller first.
    pub(crate) fn pairs(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.candidates.held()
    }

    /// Makes room for this number of slots, at most [`MOST_SLOTS`], if there is less.
    pub(crate) fn make_room(&mut self, slots: usize) {
        self.proxies.make_room(slots);
        if self.proxies.volumes().are_used() {
            self.candidates.make_room(slots);
        }
    }

    /// Removes a proxy; its pairs end without an event.
    pub(crate) fn remove(&mut self, slot: u32) {
        self.proxies.remove(slot);
        self.candidates.forget_acquaintance(slot);
    }

    /// Whether the box of a slot's proxy has ever overlapped that of another that it might meet, if volumes are in use.
    pub(crate) fn is_acquainted(&self, slot: u32) -> bool {
        self.candidates.acquainted().contains(slot as usize)
    }

    /// Calls `visit` with each of these slots and each other one, whose boxes overlapped at the end of the last update, that might touch,
    /// and that are not held, by their volumes alone. Takes time in proportion to their candidates, if few are listed time and again.
    pub(crate) fn visit_near(&mut self, listed: &[u32], mut visit: impl FnMut([u32; 2])) {
        let keys = &self.proxies.keys;
        self.candidates
            .visit_near(listed, self.proxies.len(), |pair| {
                let [a, b] = pair.map(|slot| keys[slot as usize]);
                if a.may_touch(b) {
                    visit(pair);
                }
            });
    }

    /// Fills in what it knows: pairs, candidates, layers, the foresight, full searches.
    pub(crate) fn describe(&self, stats: &mut Stats) {
        stats.pairs = self.candidates.held_count;
        stats.candidates = self.candidates.len();
        stats.foresight = u32::from(self.foresight.moves);
        stats.work = self.work;
        stats.full_searches = self.full_searches;
        self.layers.describe(stats);
    }
}
