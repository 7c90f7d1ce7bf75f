//! The broad phase of a method.

use super::anew::Anew;
use super::common_box::CommonBox;
use super::ours::{Kernel, Settings, UnisizeBroadPhase};
use super::scenes::Observed;
use super::scenes::rapier::prelude::*;
use crate::method::{Margin, Method, Search};
use cpu_time::ThreadTime;
use std::time::Duration;

/// A broad phase of a kind that is known at run time only. `Box` itself does not implement Rapier's trait.
pub(super) struct AnyBroadPhase {
    inner: Box<dyn BroadPhase>,
    /// The processor time of the last update.
    pub(super) last: Duration,
}

impl AnyBroadPhase {
    pub(super) fn new(inner: Box<dyn BroadPhase>) -> Self {
        Self {
            inner,
            last: Duration::ZERO,
        }
    }
}

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
        let start = ThreadTime::now();
        self.inner
            .update(params, colliders, bodies, modified, removed, events);
        self.last = start.elapsed();
    }
}

/// An empty broad phase under observation, of which nothing is asked yet.
pub(super) fn create(method: Method, typical_size: Real) -> Observed<AnyBroadPhase> {
    Observed::new(AnyBroadPhase::new(boxed(method, typical_size)))
}

fn boxed(method: Method, typical_size: Real) -> Box<dyn BroadPhase> {
    let kernel = match method.search {
        Search::Rapier => return Box::new(DefaultBroadPhase::new()),
        Search::CommonBox => return Box::new(Anew::new(CommonBox::new(1.0))),
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
