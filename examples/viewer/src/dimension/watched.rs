//! The broad phase of a stage, which may replace another in the midst of a simulation.

use super::ours::{Kernel, Settings, Stats, UnisizeBroadPhase};
use super::rapier::prelude::*;
use super::rivals::{Rivals, key};
use super::scenes::Observed;
use super::show::HeldPairs;
use crate::choice::Choice;
use crate::setup::{KernelName, Setup};
use std::collections::BTreeSet;
use std::time::{Duration, Instant};

/// The broad phase that drives a simulation, and the other one if both are timed.
pub(crate) struct Watched {
    rivals: Rivals,
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
        let kernel = match setup.kernel {
            KernelName::GridSweep => Kernel::GridSweep,
            KernelName::RankSweep => Kernel::RankSweep,
            KernelName::BruteForce => Kernel::BruteForce,
        };
        let settings = Settings::default()
            .with_kernel(kernel)
            .with_margin(setup.margin as Real);
        Self {
            rivals: Rivals::new(
                Observed::new(UnisizeBroadPhase::with_settings(settings)),
                setup.choice,
                setup.times_both,
                has_contacts,
            ),
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
        Some(self.rivals.unisize.as_ref()?.inner.stats())
    }

    /// How many pairs Rapier's own broad phase holds, if it takes part.
    pub(crate) fn default_pair_count(&self) -> Option<usize> {
        Some(self.rivals.default.as_ref()?.held().len())
    }

    /// Whether both hold the same pairs, if both take part.
    pub(crate) fn agree(&self) -> Option<bool> {
        let ours = &self.rivals.unisize.as_ref()?.inner;
        let default = self.rivals.default.as_ref()?;
        let are_as_many = ours.stats().pairs == default.held().len();
        Some(are_as_many && ours.pairs().all(|pair| default.holds(pair)))
    }

    pub(crate) fn clock(&self) -> Clock {
        Clock {
            unisize: self.rivals.elapsed(Choice::Unisize),
            default: self.rivals.elapsed(Choice::Default),
            all: self.elapsed,
        }
    }

    /// Ends the inherited pairs that this broad phase does not hold. It reports the others as new, which Rapier ignores.
    fn settle(&mut self, colliders: &ColliderSet, events: &mut Vec<BroadPhasePairEvent>) {
        let held: BTreeSet<_> = self.pairs().into_iter().map(key).collect();
        let ended = self.inherited.drain(..).filter(|inherited| {
            let exists = |handle| colliders.get(handle).is_some();
            exists(inherited.collider1)
                && exists(inherited.collider2)
                && !held.contains(&key(*inherited))
        });
        events.extend(ended.map(BroadPhasePairEvent::DeletePair));
    }
}

impl HeldPairs for Watched {
    fn pairs(&self) -> Vec<ColliderPair> {
        self.rivals.pairs()
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
        let rivals = &mut self.rivals;
        rivals.update(params, colliders, bodies, modified, removed, events);
        if !self.inherited.is_empty() {
            self.settle(colliders, events);
        }
        self.elapsed += start.elapsed();
    }
}
