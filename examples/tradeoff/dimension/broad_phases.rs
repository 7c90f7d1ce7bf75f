//! The broad phase of a method.

use super::common_box::CommonBox;
use super::ours::{Kernel, Settings, UnisizeBroadPhase};
use super::scenes::Observed;
use super::scenes::rapier::prelude::*;
use crate::method::{Margin, Method, Search};

/// A broad phase of a kind that is known at run time only. `Box` itself does not implement Rapier's trait.
pub(super) struct AnyBroadPhase(Box<dyn BroadPhase>);

impl BroadPhase for AnyBroadPhase {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        let Self(inner) = self;
        inner.update(params, colliders, bodies, modified, removed, events);
    }
}

/// An empty broad phase under observation, of which nothing is asked yet.
pub(super) fn create(method: Method, typical_size: Real) -> Observed<AnyBroadPhase> {
    Observed::new(AnyBroadPhase(boxed(method, typical_size)))
}

fn boxed(method: Method, typical_size: Real) -> Box<dyn BroadPhase> {
    let kernel = match method.search {
        Search::Rapier => return Box::new(DefaultBroadPhase::new()),
        Search::CommonBox => return Box::new(CommonBox::default()),
        Search::GridSweep => Kernel::GridSweep,
        Search::RankSweep => Kernel::RankSweep,
        Search::BruteForce => Kernel::BruteForce,
    };
    let settings = Settings::default().with_kernel(kernel);
    Box::new(UnisizeBroadPhase::with_settings(match method.margin {
        Margin::Default => settings,
        Margin::Sizes(sizes) => settings.with_margin(sizes * typical_size),
    }))
}
