//! The broad phase of a method.

use super::AnyBroadPhase;
use super::CommonBox;
use super::anew::Anew;
use super::fed::Fed;
use super::hash_grid::HashGrid;
use super::newer::Rapier036;
use super::ours::{Settings, UnisizeBroadPhase};
use super::scenes::Observed;
use super::scenes::rapier::prelude::*;
use crate::missed::method::{Feed, Method, Search};

/// An empty broad phase under observation, of which nothing is asked yet. `dt` is the time of a step.
pub(super) fn create(method: Method, typical_size: Real, dt: Real) -> Observed<AnyBroadPhase> {
    let Method { search, feed } = method;
    let inner = boxed(search);
    let fed = if feed == Feed::PLAIN {
        inner
    } else {
        Box::new(Fed::new(inner, feed, typical_size, dt))
    };
    Observed::new(AnyBroadPhase::new(fed))
}

fn boxed(search: Search) -> Box<dyn BroadPhase> {
    match search {
        Search::Unisize {
            kernel,
            foresight,
            has_margin,
        } => {
            let settings = Settings::default()
                .with_kernel(kernel)
                .with_foresight(foresight)
                .with_margin((!has_margin).then_some(0.0));
            Box::new(UnisizeBroadPhase::with_settings(settings))
        }
        Search::Rapier027 => Box::new(DefaultBroadPhase::new()),
        Search::Rapier036 => Box::new(Rapier036::default()),
        Search::CommonBox(share) => Box::new(Anew::new(CommonBox::new(share))),
        Search::HashGrid => Box::new(Anew::new(HashGrid::default())),
    }
}
