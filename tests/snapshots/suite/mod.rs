//! The suite: one source for every flavour, which the module that includes it names as `rapier`.

use super::{Kernel, PairFilter, Settings, Stats, UnisizeBroadPhase, rapier, scenes};

mod damage;
mod settings;
mod simulations;

#[path = "../../crowd/mod.rs"]
mod crowd;
