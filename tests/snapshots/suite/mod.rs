//! The suite: one source for every flavour, which the module that includes it names as `rapier`.

use super::{PairFilter, Settings, Stats, UnisizeBroadPhase, rapier};

mod damage;
mod settings;

#[path = "../../common/crowd.rs"]
mod crowd;
