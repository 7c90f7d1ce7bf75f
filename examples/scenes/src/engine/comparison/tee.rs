//! Two broad phases in the place of one.
//!
//! Each update goes to both, with the very same arguments; only the events of the default go on to Rapier.
//! Both are timed, and what both report is taken down.

use super::both::{Both, Side};
use super::held_pairs::HeldPairs;
use super::journal::{Event, Journal};
use super::rapier::prelude::*;
use super::timing::Timing;
use std::time::Instant;

/// Two broad phases in the place of one.
pub(super) struct Tee<C> {
    default: DefaultBroadPhase,
    /// The broad phase that is compared with the default.
    pub(super) candidate: C,
    /// What both hold, by their events.
    pub(super) held: HeldPairs,
    /// What both have reported since the last look at the contacts.
    pub(super) journals: Both<Journal>,
    /// How long both took.
    pub(super) timings: Both<Timing>,
    /// How many events changed nothing.
    pub(super) redundant: Both<usize>,
    /// The first redundant event of the candidate.
    pub(super) first_redundant: Option<String>,
    candidate_events: Vec<BroadPhasePairEvent>,
    step: usize,
    update_of_step: usize,
}

impl<C: BroadPhase> Tee<C> {
    pub(super) fn new(candidate: C) -> Self {
        Self {
            default: DefaultBroadPhase::new(),
            candidate,
            held: HeldPairs::default(),
            journals: Both::default(),
            timings: Both::default(),
            redundant: Both::default(),
            first_redundant: None,
            candidate_events: Vec::new(),
            step: 0,
            update_of_step: 0,
        }
    }

    /// To be called before each step.
    pub(super) fn begin_step(&mut self) {
        self.step += 1;
        self.update_of_step = 0;
    }

    /// Takes down what one side has reported in an update.
    fn record(&mut self, side: Side, removed: &[ColliderHandle], events: &[BroadPhasePairEvent]) {
        self.journals[side].record(removed, events);
        for event in events.iter().map(Event::from) {
            let held = matches!(event, Event::Add(_));
            let pair = event.pair().into();
            if !self.held.set(side, pair, held) {
                self.redundant[side] += 1;
                if side == Side::Candidate && self.first_redundant.is_none() {
                    self.first_redundant = Some(format!(
                        "in update {} the candidate reports the pair {pair} as {}",
                        self.update_of_step,
                        if held {
                            "new, which it holds already"
                        } else {
                            "ended, which it does not hold"
                        }
                    ));
                }
            }
        }
    }
}

impl<C: BroadPhase> BroadPhase for Tee<C> {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        // The one that goes second finds the colliders in the cache. Most steps have two updates, of which
        // only the second has much to do: the turn has to change with both.
        let first = if (self.step + self.update_of_step) % 2 == 0 {
            Side::Default
        } else {
            Side::Candidate
        };
        self.update_of_step += 1;
        let busy = !modified.is_empty() || !removed.is_empty();
        let start_of_events = events.len();
        self.candidate_events.clear();

        for side in [first, first.other()] {
            let (broad_phase, events): (&mut dyn BroadPhase, _) = match side {
                Side::Default => (&mut self.default, &mut *events),
                Side::Candidate => (&mut self.candidate, &mut self.candidate_events),
            };
            let start = Instant::now();
            broad_phase.update(params, colliders, bodies, modified, removed, events);
            self.timings[side].record(start.elapsed(), busy);
        }

        self.held.remove(removed);
        self.record(Side::Default, removed, &events[start_of_events..]);
        let candidate_events = std::mem::take(&mut self.candidate_events);
        self.record(Side::Candidate, removed, &candidate_events);
        self.candidate_events = candidate_events;
    }
}
