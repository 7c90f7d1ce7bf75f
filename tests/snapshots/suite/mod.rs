//! The suite: one source for every flavour, which the module that includes it names as `rapier`.

use super::rapier;
use super::{Kernel, Observed, PairEvent, PairFilter, Scene, Settings, Stats, UnisizeBroadPhase};

mod damage;
mod drift;
mod settings;
mod simulations;

#[path = "../../crowd/mod.rs"]
mod crowd;

/// What a broad phase tells of its last update and holds; not what it does by the way, which a restored one does in another way.
fn told(stats: &Stats) -> [u64; 8] {
    let Stats {
        proxies,
        refused,
        pairs,
        listed,
        moved,
        added,
        deleted,
        updates,
        ..
    } = *stats;
    [
        proxies,
        refused,
        pairs,
        listed,
        moved,
        added,
        deleted,
        updates as usize,
    ]
    .map(|n| n as u64)
}
