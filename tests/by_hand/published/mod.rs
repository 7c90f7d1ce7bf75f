//! The published Rapier 0.36, whose pipelines accept no custom broad phase. `stepped` runs next to its `PhysicsPipeline`, and compares the
//! pairs with those of the narrow phase. `handed_over` passes boxes by `set_aabbs`. `tests/sequences` checks random updates against a model,
//! and `benches/patched/twins` checks whole worlds on a patched copy.

use super::rapier::prelude::*;
use super::{PairFilter, Settings, UnisizeBroadPhase};

mod handed_over;
mod stepped;
