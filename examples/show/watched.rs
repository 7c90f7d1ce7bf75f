//! The broad phase that drives the simulation, timed, and on request compared with the other one.

use super::choice::Choice;
use super::options::Options;
use super::ours::UnisizeBroadPhase;
use super::rapier::prelude::*;
use super::scenes::{HeldPairs, Show};
use super::side::{Side, pair};
use std::collections::BTreeSet;
use std::time::Duration;

/// The broad phase that drives a simulation, and the other one if pairs are compared.
pub(crate) struct Watched {
    unisize: Option<Side<UnisizeBroadPhase>>,
    default: Option<Side<DefaultBroadPhase>>,
    choice: Choice,
    /// Whether pairs are reported to Rapier.
    has_contacts: bool,
}

impl Watched {
    pub(crate) fn new<S: Show>(options: &Options) -> Self {
        let choice = options.broad_phase;
        let takes_part = |side| options.verify_pairs || side == choice;
        Self {
            unisize: takes_part(Choice::Unisize)
                .then(|| Side::new(UnisizeBroadPhase::new(), options.verify_pairs)),
            // It has no list of its pairs.
            default: takes_part(Choice::Default).then(|| Side::new(DefaultBroadPhase::new(), true)),
            choice,
            has_contacts: S::CONTACTS,
        }
    }

    /// The name of the broad phase.
    pub(crate) fn name(&self) -> &'static str {
        self.choice.name()
    }

    /// The number of pairs held.
    pub(crate) fn pair_count(&self) -> usize {
        match (&self.unisize, &self.default) {
            (Some(unisize), _) => unisize.broad_phase.stats().pairs,
            (None, default) => default
                .iter()
                .flat_map(|side| &side.held)
                .map(BTreeSet::len)
                .sum(),
        }
    }

    /// The time that its updates took.
    pub(crate) fn elapsed(&self) -> Duration {
        let elapsed = match self.choice {
            Choice::Unisize => self.unisize.as_ref().map(|side| side.elapsed),
            Choice::Default => self.default.as_ref().map(|side| side.elapsed),
        };
        elapsed.unwrap_or_default()
    }

    /// How the pairs of the two broad phases differ, if both run and they do.
    pub(crate) fn difference(&self) -> Option<String> {
        let (unisize, default) = (self.unisize.as_ref()?, self.default.as_ref()?);
        let listed: Vec<_> = self.pairs().into_iter().map(pair).collect();
        let (told, rapier) = (unisize.held.as_ref()?, default.held.as_ref()?);
        let ours: BTreeSet<_> = listed.iter().copied().collect();
        if ours.len() != listed.len() {
            return Some("unisize lists a pair twice".to_owned());
        }
        if ours != *told {
            return Some("the pairs that unisize lists are not those of its events".to_owned());
        }
        let (missing, spurious) = (rapier.difference(&ours), ours.difference(rapier));
        let (missing, spurious): (Vec<_>, Vec<_>) = (missing.collect(), spurious.collect());
        let first = missing.first().or(spurious.first())?;
        Some(format!(
            "unisize misses {} pairs and has {} others; the first is {first:?}",
            missing.len(),
            spurious.len(),
        ))
    }
}

impl HeldPairs for Watched {
    fn pairs(&self) -> Vec<ColliderPair> {
        match (&self.unisize, &self.default) {
            (Some(unisize), _) => unisize.broad_phase.pairs().collect(),
            (None, Some(default)) => default.pairs(),
            (None, None) => Vec::new(),
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
        }
    }
}
