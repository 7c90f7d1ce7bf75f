//! The pair set over time: proxies in, changes of the pair set out.
//!
//! A *proxy* is a box in a numbered slot. Between two updates, proxies are placed, moved and removed; [`PairTracker::update`] makes an
//! update of these changes and reports which pairs begin and end.
//!
//! The pairs whose fat boxes overlap are the candidates: the neighbour list of molecular dynamics (Verlet 1967), made exact. ARCHITECTURE.md
//! says why that is right.

mod candidates;
mod changes;
mod foresight;
mod layers;
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

use crate::aabb::Aabb;
use crate::real::Real;
use crate::stats::Stats;
use crate::volume::Volume;
use candidates::{Candidates, PairState};
pub(crate) use changes::Changes;
use foresight::Foresight;
use layers::Layers;
use policy::Work;
pub(crate) use proxies::{Notes, Proxies, ProxyChunk};
#[cfg(feature = "serde-serialize")]
pub(crate) use snapshot::TrackerSnapshot;
#[cfg(test)]
pub(crate) use tests::Side;

/// What an update asks about colliders.
pub(crate) trait Colliders<R, const D: usize>: Sync {
    /// The present volume of a slot, extended as [`Volumes`](volumes::Volumes::extension) say.
    fn volume(&self, slot: u32) -> Volume<R, D>;

    /// Whether the contact of a held pair is active. Removing an active contact wakes its bodies, so such a pair does not end while its boxes
    /// overlap.
    fn is_active(&self, pair: [u32; 2]) -> bool;
}

/// A property of a proxy that decides with which others it may become a pair. A pair that its keys come to forbid stays until its boxes part.
pub(crate) trait FilterKey: Copy + Debug + Default + PartialEq + Send + Sync {
    /// Whether the two may become a pair; the same in either order.
    fn may_meet(self, other: Self) -> bool;

    /// Two proxies with the same number may not meet.
    fn clique(self) -> Option<u32> {
        None
    }

    /// Whether the two, if they meet, have a contact and not only an intersection; the same in either order.
    fn may_touch(self, _other: Self) -> bool {
        true
    }

    /// Whether a proxy whose key has changed from `former` to this one gets a new box, without a margin.
    fn renews_box(self, _former: Self) -> bool {
        false
    }
}

/// The proxies and the pairs they form.
#[derive(Clone, Debug, Default)]
pub(crate) struct PairTracker<R: Real, const D: usize, K> {
    pub(crate) proxies: Proxies<R, D, K>,
    foresight: Foresight,
    /// The work of searching since the last full search, that one included.
    cost: Work,
    pub(crate) full_searches: u64,
    candidates: Candidates,
    layers: Layers<R, D>,
}

impl<R: Real, const D: usize, K: FilterKey> PairTracker<R, D, K> {
    /// A tracker without proxies. With `volumes`, a pair is held only if its volumes meet.
    pub(crate) fn new(volumes: bool) -> Self {
        let mut tracker = Self::default();
        tracker.proxies.volumes.are_used = volumes;
        tracker
    }

    /// The held pairs, by slots, smaller first.
    pub(crate) fn pairs(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.candidates.of_state(PairState::Held)
    }

    /// Makes room for this number of slots, at most [`MAX_BOXES`](crate::grid_sweep::MAX_BOXES), if there is less.
    pub(crate) fn make_room(&mut self, slots: usize) {
        self.proxies.make_room(slots);
        let volumes = self.proxies.volumes.are_used;
        self.candidates.make_room(self.proxies.len(), volumes);
    }

    /// Removes a proxy; its pairs end without an event.
    pub(crate) fn remove(&mut self, slot: u32) {
        self.proxies.previous[slot as usize] = Aabb::ABSENT;
        self.proxies.volumes.forget(slot);
        self.proxies.clear_box(slot);
        self.candidates.acquainted.remove(slot as usize);
    }

    /// Whether the box of a slot's proxy has ever overlapped that of another that it might meet, if volumes are in use.
    pub(crate) fn is_acquainted(&self, slot: u32) -> bool {
        self.candidates.acquainted.contains(slot as usize)
    }

    /// Calls `visit` with each pair of one of these slots whose boxes overlapped at the end of the last update, that might touch, and that is
    /// near: not held because of its volumes, whatever its keys have come to say. Passes over the candidates that are not cold.
    pub(crate) fn visit_near(&mut self, listed: &[u32], mut visit: impl FnMut([u32; 2])) {
        let keys = &self.proxies.keys;
        self.candidates.visit_near(listed, |pair| {
            let [a, b] = pair.map(|slot| keys[slot as usize]);
            if a.may_touch(b) {
                visit(pair);
            }
        });
    }

    /// Fills in the held pairs and the full searches.
    pub(crate) fn describe(&self, stats: &mut Stats) {
        stats.pairs = self.candidates.held_count;
        stats.full_searches = self.full_searches;
    }
}
