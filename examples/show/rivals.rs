//! The broad phase that drives a simulation, timed, and on request the other one on the same colliders.

use super::choice::Choice;
use super::ours::UnisizeBroadPhase;
use super::rapier::prelude::*;
use super::scenes::Observed;
use super::show::HeldPairs;
use std::time::Duration;

/// One of the two broad phases, or both.
pub(crate) struct Rivals {
    pub(crate) unisize: Option<Observed<UnisizeBroadPhase>>,
    pub(crate) default: Option<Observed<DefaultBroadPhase>>,
    /// The one that drives.
    pub(crate) choice: Choice,
}

impl Rivals {
    /// The chosen one, or `both`. Rapier hears of pairs from the chosen one, if it `has_contacts`, and never from the other.
    pub(crate) fn new(
        unisize: Observed<UnisizeBroadPhase>,
        choice: Choice,
        both: bool,
        has_contacts: bool,
    ) -> Self {
        // The default has no list of its pairs.
        let default = Observed::new(DefaultBroadPhase::new()).with_held();
        Self {
            unisize: rival(unisize, both, choice == Choice::Unisize, has_contacts),
            default: rival(default, both, choice == Choice::Default, has_contacts),
            choice,
        }
    }

    /// The time that the updates of one of them took, if it takes part.
    pub(crate) fn elapsed(&self, of: Choice) -> Option<Duration> {
        let timing = match of {
            Choice::Unisize => self.unisize.as_ref().map(Observed::timing),
            Choice::Default => self.default.as_ref().map(Observed::timing),
        };
        timing.map(|timing| timing.total)
    }
}

fn rival<B: BroadPhase>(
    broad_phase: Observed<B>,
    both: bool,
    is_chosen: bool,
    has_contacts: bool,
) -> Option<Observed<B>> {
    let clocked = broad_phase.clocked();
    match is_chosen {
        true if has_contacts => Some(clocked),
        true => Some(clocked.silent()),
        false => both.then(|| clocked.silent()),
    }
}

/// A pair as indices and generations, the smaller first.
pub(crate) fn key(pair: ColliderPair) -> [(u32, u32); 2] {
    let [first, second] = [pair.collider1, pair.collider2].map(ColliderHandle::into_raw_parts);
    [first.min(second), first.max(second)]
}

impl HeldPairs for Rivals {
    fn pairs(&self) -> Vec<ColliderPair> {
        match (self.choice, &self.unisize, &self.default) {
            (Choice::Unisize, Some(unisize), _) => unisize.inner.pairs().collect(),
            (Choice::Default, _, Some(default)) => {
                // In an order that does not depend on hashing.
                let mut pairs: Vec<_> = default.held().iter().copied().collect();
                pairs.sort_unstable_by_key(|&pair| key(pair));
                pairs
            }
            _ => Vec::new(),
        }
    }
}

impl BroadPhase for Rivals {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        if let Some(unisize) = &mut self.unisize {
            unisize.update(params, colliders, bodies, modified, removed, events);
        }
        if let Some(default) = &mut self.default {
            default.update(params, colliders, bodies, modified, removed, events);
        }
    }
}
