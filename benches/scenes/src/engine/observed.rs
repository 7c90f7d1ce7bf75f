//! A broad phase under observation.
//!
//! It takes the place of the broad phase that it wraps, and records on request the time, the lists, the events, and the set of pairs
//! that the events amount to. It records nothing else, so that a plain one costs nothing.

use super::pairs::{PairEvent, Pairs, in_order};
use super::rapier::prelude::*;
use super::version::{self, BroadPhase};
use crate::{Clock, Timing};
use std::collections::HashSet;

mod tee;

pub use tee::Tee;

/// A broad phase under observation.
#[derive(Default)]
pub struct Observed<B> {
    timing: Option<(Clock, Timing)>,
    has_lists: bool,
    has_events: bool,
    updates: Vec<Update>,
    held: Option<Held>,
    copies: Option<Copies>,
    is_sorted: bool,
    /// The broad phase itself.
    pub inner: B,
}

/// How often an event is passed on.
type Copies = Box<dyn FnMut(PairEvent) -> usize + Send + Sync>;

/// The pairs that the events of a broad phase amount to.
#[derive(Default)]
struct Held {
    pairs: Pairs,
    /// The first event that contradicts those before it.
    fault: Option<PairEvent>,
}

/// The lists and the events of an update.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Update {
    /// The colliders listed as modified; empty unless [lists](Observed::with_lists) were asked for.
    pub modified: Vec<ColliderHandle>,
    /// The colliders listed as removed.
    pub removed: Vec<ColliderHandle>,
    /// The events in their order; empty unless [events](Observed::with_events) were asked for.
    pub events: Vec<PairEvent>,
}

impl<B: BroadPhase> Observed<B> {
    /// Wraps a broad phase, and records nothing yet.
    pub fn new(inner: B) -> Self {
        Self {
            timing: None,
            has_lists: false,
            has_events: false,
            updates: Vec::new(),
            held: None,
            copies: None,
            is_sorted: false,
            inner,
        }
    }

    /// Times the updates by a clock.
    pub fn clocked(mut self, clock: Clock) -> Self {
        self.timing = Some((clock, Timing::default()));
        self
    }

    /// Keeps the lists of each update until they are [taken](Self::take_updates).
    pub fn with_lists(mut self) -> Self {
        self.has_lists = true;
        self
    }

    /// Keeps the events of each update, and the removed colliders, until they are [taken](Self::take_updates).
    pub fn with_events(mut self) -> Self {
        self.has_events = true;
        self
    }

    /// Keeps the set of pairs that the events amount to. Without it, the methods that return pairs panic.
    pub fn with_held(mut self) -> Self {
        self.held = Some(Held::default());
        self
    }

    /// Passes each event to Rapier this many times, which makes a faulty broad phase of a sound one.
    pub fn repeating(
        mut self,
        copies: impl FnMut(PairEvent) -> usize + Send + Sync + 'static,
    ) -> Self {
        self.copies = Some(Box::new(copies));
        self
    }

    /// Sorts the events of each update: new pairs first, then by handles.
    ///
    /// Rapier's own broad phase reports the ends of pairs in the order of a hash map with a random seed, and the last bits of the
    /// solver's result depend on that order. A simulation with sorted events is repeatable.
    pub fn sorted(mut self) -> Self {
        self.is_sorted = true;
        self
    }

    /// Keeps the events from Rapier, so that its narrow phase stays idle.
    pub fn silent(self) -> Self {
        self.repeating(|_| 0)
    }
}

impl<B> Observed<B> {
    /// How long the updates took; zero unless it is [clocked](Self::clocked).
    pub fn timing(&self) -> Timing {
        self.timing.map(|(_, timing)| timing).unwrap_or_default()
    }

    /// Forgets the times so far, also of the first update.
    pub fn restart_timing(&mut self) {
        if let Some((_, timing)) = &mut self.timing {
            timing.restart();
        }
    }

    /// The updates since this was last called.
    pub fn take_updates(&mut self) -> Vec<Update> {
        std::mem::take(&mut self.updates)
    }

    /// The events of the updates since they were last taken.
    pub fn take_events(&mut self) -> Vec<PairEvent> {
        let updates = self.updates.drain(..);
        updates.flat_map(|update| update.events).collect()
    }

    /// The pairs held by its events, the smaller handle first.
    pub fn held(&self) -> &HashSet<ColliderPair> {
        &self.book().pairs
    }

    /// Whether it holds this pair, whichever of the two comes first.
    pub fn holds(&self, pair: ColliderPair) -> bool {
        self.held().contains(&in_order(pair))
    }

    /// The first event that contradicts those before it: a pair that is added though it is held, or deleted though
    /// it is not.
    pub fn held_fault(&self) -> Option<PairEvent> {
        self.book().fault
    }

    fn book(&self) -> &Held {
        self.held.as_ref().expect("the pairs were asked for")
    }
}

impl Held {
    /// Follows one update.
    fn follow(&mut self, removed: &[ColliderHandle], events: &[BroadPhasePairEvent]) {
        if !removed.is_empty() {
            // The pairs of a removed collider end without an event.
            let removed: HashSet<_> = removed.iter().collect();
            self.pairs.retain(|pair| {
                !removed.contains(&pair.collider1) && !removed.contains(&pair.collider2)
            });
        }
        for event in events.iter().map(PairEvent::from) {
            let is_change = match event {
                PairEvent::Add(pair) => self.pairs.insert(in_order(pair)),
                PairEvent::Delete(pair) => self.pairs.remove(&in_order(pair)),
            };
            if !is_change {
                self.fault.get_or_insert(event);
            }
        }
    }
}

impl<B: BroadPhase> BroadPhase for Observed<B> {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        self.observe([modified, removed], events, |inner, events| {
            inner.update(params, colliders, bodies, modified, removed, events);
        });
    }

    version::when_boxes_are_handed_over! {
        fn set_aabbs(&mut self, params: &IntegrationParameters, boxes: &[(ColliderHandle, Aabb)]) {
            let start = self.timing.map(|(clock, _)| clock.start());
            self.inner.set_aabbs(params, boxes);
            if let (Some((_, timing)), Some(start)) = (&mut self.timing, start) {
                timing.record_boxes(start.elapsed());
            }
        }

        fn update_in_pipeline(&mut self, input: &PipelineInput<'_>, events: &mut Vec<BroadPhasePairEvent>) {
            self.observe([input.modified, input.removed], events, |inner, events| {
                inner.update_in_pipeline(input, events);
            });
        }

        fn clear(&mut self) {
            self.inner.clear();
        }

        fn is_empty(&self) -> bool {
            self.inner.is_empty()
        }

        fn visit_unreported(&self, visit: &mut dyn FnMut(ColliderHandle)) {
            self.inner.visit_unreported(visit);
        }

        fn bvh(&self) -> &Bvh {
            self.inner.bvh()
        }

        // A copy is not observed.
        fn clone_box(&self) -> Box<dyn BroadPhase> {
            self.inner.clone_box()
        }
    }
}

impl<B: BroadPhase> Observed<B> {
    /// Runs an update with these modified and removed colliders, and records what is requested.
    fn observe(
        &mut self,
        [modified, removed]: [&[ColliderHandle]; 2],
        events: &mut Vec<BroadPhasePairEvent>,
        update: impl FnOnce(&mut B, &mut Vec<BroadPhasePairEvent>),
    ) {
        let first = events.len();
        let start = self.timing.map(|(clock, _)| clock.start());
        update(&mut self.inner, events);
        if let (Some((_, timing)), Some(start)) = (&mut self.timing, start) {
            timing.record(start.elapsed());
        }

        let reported = &mut events[first..];
        if self.is_sorted {
            reported.sort_by_key(|event| PairEvent::from(event).sort_key());
        }
        if let Some(held) = &mut self.held {
            held.follow(removed, reported);
        }
        if self.has_lists || self.has_events {
            let modified = if self.has_lists { modified } else { &[] };
            let reported = if self.has_events { reported } else { &mut [] };
            self.updates.push(Update {
                modified: modified.to_vec(),
                removed: removed.to_vec(),
                events: reported.iter().map(PairEvent::from).collect(),
            });
        }
        if let Some(copies) = &mut self.copies {
            for event in events.split_off(first) {
                let event = PairEvent::from(&event);
                events.extend((0..copies(event)).map(|_| BroadPhasePairEvent::from(event)));
            }
        }
    }
}
