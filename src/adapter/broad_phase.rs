//! The broad phase itself: Rapier's lists of colliders in, Rapier's pair events out.

use std::sync::OnceLock;

use super::collider_box::Prediction;
use super::outline::Outline;
use super::rapier::dynamics::{IntegrationParameters, RigidBodySet};
use super::rapier::geometry::{
    BroadPhasePairEvent, Collider, ColliderHandle, ColliderPair, ColliderSet,
};
use super::rapier::math::{DIM, Real};
use super::rapier::parry::partitioning::Bvh;
use super::reading_order::{self, ReadingOrder};
use super::reading_part::{self, Findings, ReadingPart};
use super::version::PairFilter;
use super::world::World;
use super::{Settings, Stats};
use crate::pair_tracker::{Layers, PairChange, PairTracker};
use crate::stopwatch::{PhaseTimes, Stopwatch};
use crate::{Aabb, parallel};

/// A broad phase for scenes of many colliders of about the same size. In Rapier 0.27, give it to `PhysicsPipeline::step` or
/// `CollisionPipeline::step` in the place of `DefaultBroadPhase`; in 0.36, whose pipelines take none but their own, call its
/// `update`.
///
/// It keeps a box for every enabled collider, the same that Rapier's own broad phase keeps, and reports
/// every pair whose boxes overlap, as that one does. Contacts, intersections and the bodies that are woken are
/// therefore the same.
///
/// An update in which no collider has left its margin costs one box comparison for each listed collider. The pairs
/// to come are searched for some updates ahead, so most updates only compare boxes that are known to be near each other.
/// What moves otherwise than was foreseen is looked up among the others in about **O(log n)** each; where that is much,
/// there is one run of the [kernel](super::Kernel) over all boxes.
#[derive(Clone)]
pub struct UnisizeBroadPhase {
    pub(super) tracker: PairTracker<Real, DIM>,
    /// The generation of the collider in each slot, the slot being the index of its handle; `None` where
    /// there is none.
    pub(super) generations: Vec<Option<u32>>,
    /// The outline of the collider in each slot, as many as generations.
    pub(super) outlines: Vec<Outline>,
    pub(super) layers: Layers<Real, DIM>,
    pub(super) filter: PairFilter,
    reading_order: ReadingOrder,
    /// Scratch: listed colliders that are not known, what has come of reading the parts, and how pairs have changed.
    strangers: Vec<ColliderHandle>,
    findings: Vec<Findings>,
    changes: Vec<PairChange>,
    pub(super) settings: Settings,
    pub(super) stats: Stats,
    pub(super) has_warned: bool,
    /// The tree for queries, if any were made since the boxes last changed.
    pub(super) tree: OnceLock<Bvh>,
}

impl std::fmt::Debug for UnisizeBroadPhase {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("UnisizeBroadPhase")
            .field("settings", &self.settings)
            .field("stats", &self.stats())
            .finish_non_exhaustive()
    }
}

impl Default for UnisizeBroadPhase {
    fn default() -> Self {
        Self::with_settings(Settings::default())
    }
}

impl UnisizeBroadPhase {
    /// A broad phase without any colliders, with default [`Settings`].
    pub fn new() -> Self {
        Self::default()
    }

    /// A broad phase without any colliders.
    pub fn with_settings(settings: Settings) -> Self {
        let mut tracker = PairTracker::default();
        tracker.stopwatch = Stopwatch::new(settings.timed);
        tracker.fixed_foresight = settings.foresight;
        Self {
            tracker,
            generations: Vec::new(),
            outlines: Vec::new(),
            layers: settings.kernel.layers(settings.layers),
            filter: PairFilter::default(),
            reading_order: ReadingOrder::default(),
            strangers: Vec::new(),
            findings: Vec::new(),
            changes: Vec::new(),
            settings,
            stats: Stats::default(),
            has_warned: false,
            tree: OnceLock::new(),
        }
    }

    /// The settings it was made with.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// What it holds, and what the last update did. **O(1)**.
    pub fn stats(&self) -> Stats {
        Stats {
            pairs: self.tracker.pair_count() - self.filter.withheld(),
            withheld: self.filter.withheld(),
            candidates: self.tracker.candidate_count(),
            moving: self.layers.moving(),
            foresight: self.tracker.foresight(),
            full_runs: self.tracker.full_runs(),
            classes: self.layers.classes(),
            strips: self.layers.strips(),
            times: self.tracker.stopwatch.times,
            ..self.stats
        }
    }

    /// The pairs it holds, each once, the collider with the smaller index first, in no particular order.
    /// **O(pairs)** to go through.
    pub fn pairs(&self) -> impl Iterator<Item = ColliderPair> + '_ {
        let pairs = self.tracker.pairs();
        let pairs = pairs.filter(|&pair| !self.filter.withholds(pair));
        pairs.map(|pair| collider_pair(&self.generations, pair))
    }

    /// Checks the internal invariants: the books on colliders, and the pairs held, by a full search. For tests.
    ///
    /// # Panics
    /// If an invariant is broken, which would be a bug.
    pub fn validate(&self) {
        assert_eq!(self.generations.len(), self.tracker.slots());
        assert_eq!(self.generations.len(), self.outlines.len());
        let known = self.generations.iter().flatten().count();
        assert_eq!(self.stats.proxies + self.stats.refused, known);
        assert_eq!(self.stats.proxies, self.tracker.proxies().count());
        for (slot, _) in self.tracker.proxies() {
            assert!(self.generations[slot as usize].is_some());
        }
        self.filter.validate(self.tracker.pairs());
        // Another kernel than the one in use, so that one checks the other.
        let kernel = match self.settings.kernel {
            super::Kernel::RankSweep => super::Kernel::GridSweep,
            _ => super::Kernel::RankSweep,
        };
        self.tracker.validate(&mut kernel.layers(true));
    }

    /// Forgets a collider, if it is the one that was known under its index.
    fn remove(&mut self, handle: ColliderHandle) {
        let (slot, generation) = handle.into_raw_parts();
        let Some(known) = self.generations.get_mut(slot as usize) else {
            return;
        };
        if *known == Some(generation) {
            *known = None;
            self.outlines[slot as usize] = Outline::default();
            if self.tracker.get(slot).is_some() {
                self.stats.proxies -= 1;
            } else {
                self.stats.refused -= 1;
            }
            self.tracker.remove(slot);
            self.filter.forget(slot);
        }
    }

    /// Reads listed colliders in the order of their indices.
    fn read_in_order(&mut self, handles: &[ColliderHandle], world: &World, is_shared: bool) {
        let mut order = std::mem::take(&mut self.reading_order);
        let mut strangers = std::mem::take(&mut self.strangers);
        order.insert_known(handles, &self.generations, &mut strangers, is_shared);
        // They are new or unheard of, as few are.
        for handle in strangers.drain(..) {
            self.read(handle, world);
        }
        if is_shared {
            self.read_in_parts(order.listed(), world);
        } else {
            order.drain(|slot| self.read_slot(slot, world));
        }
        self.reading_order = order;
        self.strangers = strangers;
    }

    fn read_slot(&mut self, slot: u32, world: &World) {
        // A newer collider may have taken its place since it was listed, and has been read then.
        if let Some(generation) = self.generations[slot as usize] {
            self.read(ColliderHandle::from_raw_parts(slot, generation), world);
        }
    }

    /// Reads the colliders of the slots whose bits are set, on several threads, and clears the bits.
    fn read_in_parts(&mut self, listed: &mut [u64], world: &World) {
        // Some more than threads, for some will be faster than others.
        let words = listed.len().div_ceil(4 * parallel::threads()).max(1);
        let slots = 64 * words;
        let (boxes, reaches) = self.tracker.boxes_and_reaches();
        let mut findings = std::mem::take(&mut self.findings);
        findings.resize(listed.len().div_ceil(words), Findings::default());
        let kept = self.generations.chunks(slots);
        let kept = kept.zip(self.outlines.chunks_mut(slots));
        let placed = boxes.chunks_mut(slots).zip(reaches.chunks(slots));
        let listed = listed.chunks_mut(words).zip(&mut findings);
        let mut parts: Vec<_> = (0..)
            .step_by(slots)
            .zip(listed)
            .zip(kept.zip(placed))
            .map(
                |((first_slot, (listed, findings)), (kept, placed))| ReadingPart {
                    first_slot,
                    listed,
                    generations: kept.0,
                    outlines: kept.1,
                    boxes: placed.0,
                    reaches: placed.1,
                    findings,
                },
            )
            .collect();
        parallel::for_each(&mut parts, |part| part.read(world));
        for Findings {
            moved,
            escaped,
            left,
        } in &findings
        {
            // In the order of the slots, as if each had been read when its turn came.
            let (mut moved, mut escaped) = (&moved[..], &escaped[..]);
            for &slot in left {
                self.note(take_below(&mut moved, slot), take_below(&mut escaped, slot));
                self.read_slot(slot, world);
            }
            self.note(moved, escaped);
        }
        self.findings = findings;
    }

    fn note(&mut self, moved: &[u32], escaped: &[u32]) {
        self.stats.moved += moved.len();
        self.tracker.note(moved, escaped);
    }

    /// Brings the proxy of a listed collider up to date.
    #[inline(always)]
    fn read(&mut self, handle: ColliderHandle, world: &World) {
        match world.colliders.get(handle) {
            Some(collider) if collider.is_enabled() => self.modify(handle, collider, world),
            // Listed as removed as well, as a rule; and if not, it is out of the game all the same.
            _ => self.remove(handle),
        }
    }

    #[inline(always)]
    fn modify(&mut self, handle: ColliderHandle, collider: &Collider, world: &World) {
        let (slot, generation) = handle.into_raw_parts();
        let index = slot as usize;
        if self.generations.get(index) != Some(&Some(generation)) {
            self.enlist(handle);
        }
        let aabb = world.collider_box(collider, &mut self.outlines[index]);
        match world.renewed(&self.tracker.slot_box(slot), &aabb) {
            None => {}
            Some(Some(renewed)) => {
                self.tracker.place(slot, renewed);
                self.stats.moved += 1;
            }
            Some(None) => self.admit_or_refuse(handle, aabb),
        }
    }

    /// Takes note of a collider that is new under its index.
    #[cold]
    fn enlist(&mut self, handle: ColliderHandle) {
        let (slot, generation) = handle.into_raw_parts();
        let index = slot as usize;
        if index >= self.generations.len() {
            self.generations.resize(index + 1, None);
            self.outlines.resize(index + 1, Outline::default());
            // Also if its box is not sound: how much work an update is goes by the number of slots.
            self.tracker.make_room(index + 1);
        }
        if let Some(stale) = self.generations[index] {
            // Its removal was not reported.
            self.remove(ColliderHandle::from_raw_parts(slot, stale));
        }
        self.generations[index] = Some(generation);
        // Until its box is seen to be sound.
        self.stats.refused += 1;
    }

    /// Gives a collider its first proxy, or takes it away because its box is not sound.
    #[cold]
    fn admit_or_refuse(&mut self, handle: ColliderHandle, aabb: Aabb<Real, DIM>) {
        let slot = handle.into_raw_parts().0;
        if aabb.is_valid() {
            // A new box gets no margin, as in Rapier: what never moves never needs one.
            self.tracker.place(slot, aabb);
            self.stats.moved += 1;
            self.stats.proxies += 1;
            self.stats.refused -= 1;
            return;
        }
        if self.tracker.get(slot).is_some() {
            self.tracker.lift(slot);
            self.stats.moved += 1;
            self.stats.proxies -= 1;
            self.stats.refused += 1;
        }
        if !self.has_warned {
            self.has_warned = true;
            log::warn!(
                "collider {handle:?} is left out of the broad phase until its box is sound again: \
                 {aabb:?}. Further ones are only counted, in Stats::refused."
            );
        }
    }

    /// Turns the changes of the pair set into events.
    fn report(
        &mut self,
        world: &World,
        listed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        if self.tracker.is_touched() {
            self.tree = OnceLock::new();
        }
        let Self {
            tracker,
            layers,
            filter,
            generations,
            changes,
            stats,
            ..
        } = self;
        tracker.finish(layers, |change| changes.push(change));
        let lap = tracker.stopwatch.start();
        filter.sift(changes, listed, generations, world.colliders, world.bodies);
        events.extend(changes.drain(..).map(|change| match change {
            PairChange::Added(pair) => {
                stats.added += 1;
                BroadPhasePairEvent::AddPair(collider_pair(generations, pair))
            }
            PairChange::Deleted(pair) => {
                stats.deleted += 1;
                BroadPhasePairEvent::DeletePair(collider_pair(generations, pair))
            }
        }));
        tracker.stopwatch.lap(lap, |times| &mut times.events);
    }

    /// One update, with the modified and the removed colliders in this order.
    pub(crate) fn bring_up_to_date(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        [modified_colliders, removed_colliders]: [&[ColliderHandle]; 2],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        if modified_colliders.is_empty() && removed_colliders.is_empty() {
            return;
        }
        self.stats = Stats {
            updates: self.stats.updates.wrapping_add(1),
            listed: modified_colliders.len() + removed_colliders.len(),
            moved: 0,
            added: 0,
            deleted: 0,
            ..self.stats
        };
        self.tracker.stopwatch.times = PhaseTimes::default();
        let lap = self.tracker.stopwatch.start();
        // Removals first: a modified collider may already have the index of a removed one.
        for &handle in removed_colliders {
            self.remove(handle);
        }
        let world = World {
            colliders,
            bodies,
            prediction: Prediction::new(params),
            // NaN counts as 0 too.
            margin: (self.settings.margin * params.length_unit).max(0.0),
        };
        // The order must not depend on the number of threads.
        let are_many = modified_colliders.len() >= reading_part::WORTH_A_THREAD;
        if !are_many && reading_order::is_favourable(modified_colliders) {
            for &handle in modified_colliders {
                self.read(handle, &world);
            }
        } else {
            let is_shared = are_many && parallel::threads() > 1;
            self.read_in_order(modified_colliders, &world, is_shared);
        }
        self.tracker.stopwatch.lap(lap, |times| &mut times.read);
        self.report(&world, modified_colliders, events);
    }
}

/// Splits off the slots that are smaller than this one; they ascend.
fn take_below<'a>(slots: &mut &'a [u32], slot: u32) -> &'a [u32] {
    let (below, rest) = slots.split_at(slots.partition_point(|&other| other < slot));
    *slots = rest;
    below
}

/// The handles of two slots.
fn collider_pair(generations: &[Option<u32>], pair: [u32; 2]) -> ColliderPair {
    let [first, second] = pair.map(|slot| {
        let generation = generations[slot as usize];
        let generation = generation.expect("the colliders of a held pair are known");
        ColliderHandle::from_raw_parts(slot, generation)
    });
    ColliderPair::new(first, second)
}
