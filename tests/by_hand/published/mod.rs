//! Rapier 0.36 as it is published, whose pipelines accept no broad phase but their own: `stepped` follows its `PhysicsPipeline` and
//! compares with what its narrow phase holds, and `handed_over` hands boxes over. `tests/sequences` checks random updates against a
//! model, and `benches/patched/twins` whole worlds on a patched copy.

use super::rapier::prelude::*;
use super::{PairFilter, Settings, UnisizeBroadPhase};

mod handed_over;
mod stepped;
