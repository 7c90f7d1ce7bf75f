//! The broad phase of a method.

use super::common_box::CommonBox;
use super::ours::{Kernel, Settings, UnisizeBroadPhase};
use super::scenes::rapier::prelude::*;
use crate::method::{Margin, Method, Search};

/// An empty broad phase.
pub(super) fn create(method: Method, typical_size: Real) -> Box<dyn BroadPhase> {
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
