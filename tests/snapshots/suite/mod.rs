//! The suite: one source for every flavour, which the module that includes it names as `rapier`.

use super::{PairFilter, Settings, Stats, UnisizeBroadPhase, rapier, version};

mod damage;
mod settings;

#[path = "../../common/crowd/mod.rs"]
mod crowd;
