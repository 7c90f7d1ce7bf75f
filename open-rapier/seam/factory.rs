//! What a new [`BroadPhaseBvh`](super::BroadPhaseBvh) is made with: for tests that put another broad phase below Rapier's own tests.

use super::CustomBroadPhase;
use super::custom::Custom;
use crate::alloc_prelude::*;

/// If set, `BroadPhaseBvh::new()` and `default()` are made with what this returns.
#[cfg(feature = "std")]
pub static BROAD_PHASE_FACTORY: std::sync::OnceLock<fn() -> Box<dyn CustomBroadPhase>> =
    std::sync::OnceLock::new();

impl Default for Custom {
    fn default() -> Self {
        #[cfg(feature = "std")]
        let broad_phase = BROAD_PHASE_FACTORY.get().map(|make| make());
        #[cfg(not(feature = "std"))]
        let broad_phase = None;
        Self::with(broad_phase)
    }
}
