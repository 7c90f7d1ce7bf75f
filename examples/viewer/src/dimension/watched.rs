//! The broad phase of a stage: one of the two, or both on the same colliders, timed.

use super::ours::{Kernel, Settings, Stats, UnisizeBroadPhase};
use super::rapier::prelude::*;
use super::scenes::HeldPairs;
use super::side::{Side, pair};
use crate::choice::Choice;
use crate::setup::{KernelName, Setup};
use std::collections::BTreeSet;
use std::time::{Duration, Instant};

/// The broad phase that drives a simulation, and the other one if both are timed.
pub(crate) struct Watched {
    unisize: Option<Side<UnisizeBroadPhase>>,
    default: Option<Side<DefaultBroadPhase>>,
    choice: Choice,
    /// Whether pairs are reported to Rapier.
    has_contacts: bool,
    /// The pairs that an earlier broad phase reported to Rapier and this one has not yet confirmed or ended.
    inherited: Vec<ColliderPair>,
    /// The time of all updates, including the records that are kept here.
    elapsed: Duration,
}

/// The time of all updates so far.
#[derive(Clone, Copy)]
pub(crate) struct Clock {
    pub(crate) unisize: Option<Duration>,
    pub(crate) default: Option<Duration>,
    pub(crate) all: Duration,
}

impl Watched {
    pub(crate) fn new(setup: &Setup, has_contacts: bool) -> Self {
        let takes_part = |side| setup.times_both || side == setup.choice;
        let kernel = match setup.kernel {
            KernelName::GridSweep => Kernel::GridSweep,
            KernelName::RankSweep => Kernel::RankSweep,
            KernelName::BruteForce => Kernel::BruteForce,
        };
        let settings = Settings::default()
            .with_kernel(kernel)
            .with_margin(setup.margin as Real);
        Self {
            unisize: takes_part(Choice::Unisize)
                .then(|| Side::new(UnisizeBroadPhase::with_settings(settings), false)),
            // It has no list of its pairs.
            default: takes_part(Choice::Default).then(|| Side::new(DefaultBroadPhase::new(), true)),
            choice: setup.choice,
            has_contacts,
            inherited: Vec::new(),
            elapsed: Duration::ZERO,
        }
    }

    /// Replaces the broad phases in the same world. The next step must list all colliders.
    pub(crate) fn succeeded_by(&mut self, setup: &Setup) {
        let mut inherited = std::mem::take(&mut self.inherited);
        if self.has_contacts {
            inherited.extend(self.pairs());
        }
        *self = Self {
            inherited,
            ..Self::new(setup, self.has_contacts)
        };
    }

    /// The statistics of unisize, if it takes part.
    pub(crate) fn stats(&self) -> Option<Stats> {
        Some(self.unisize.as_ref()?.broad_phase.stats())
    }

    /// How many pairs Rapier's own broad phase holds, if it takes part.
    pub(crate) fn default_pair_count(&self) -> Option<usize> {
        self.default.as_ref()?.held.as_ref().map(BTreeSet::len)
    }

    /// Whether both hold the same pairs, if both take part.
    pub(crate) fn agree(&self) -> Option<bool> {
        let ours = &self.unisize.as_ref()?.broad_phase;
        let held = self.default.as_ref()?.held.as_ref()?;
        let are_as_many = ours.stats().pairs == held.len();
        Some(are_as_many && ours.pairs().all(|ours| held.contains(&pair(ours))))
    }

    pub(crate) fn clock(&self) -> Clock {
        Clock {
            unisize: self.unisize.as_ref().map(|side| side.elapsed),
            default: self.default.as_ref().map(|side| side.elapsed),
            all: self.elapsed,
        }
    }

    /// Ends the inherited pairs that this broad phase does not hold. It reports the others as new, which Rapier ignores.
    fn settle(&mut self, colliders: &ColliderSet, events: &mut Vec<BroadPhasePairEvent>) {
        let held: BTreeSet<_> = self.pairs().into_iter().map(pair).collect();
        let ended = self.inherited.drain(..).filter(|inherited| {
            let exists = |handle| colliders.get(handle).is_some();
            exists(inherited.collider1)
                && exists(inherited.collider2)
                && !held.contains(&pair(*inherited))
        });
        events.extend(ended.map(BroadPhasePairEvent::DeletePair));
    }
}

impl HeldPairs for Watched {
    fn pairs(&self) -> Vec<ColliderPair> {
        let ours = self.unisize.as_ref().map(|side| &side.broad_phase);
        match (self.choice, ours, &self.default) {
            (Choice::Unisize, Some(unisize), _) => unisize.pairs().collect(),
            (_, _, Some(default)) => default.pairs(),
            _ => Vec::new(),
        }
    }
}

impl BroadPhase for Watched {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        let start = Instant::now();
        if let Some(side) = &mut self.unisize {
            side.update(params, colliders, bodies, modified, removed);
        }
        if let Some(side) = &mut self.default {
            side.update(params, colliders, bodies, modified, removed);
        }
        let reported = match self.choice {
            Choice::Unisize => self.unisize.as_mut().map(|side| &mut side.events),
            Choice::Default => self.default.as_mut().map(|side| &mut side.events),
        };
        if let Some(reported) = reported.filter(|_| self.has_contacts) {
            events.append(reported);
            if !self.inherited.is_empty() {
                self.settle(colliders, events);
            }
        }
        self.elapsed += start.elapsed();
    }
}
