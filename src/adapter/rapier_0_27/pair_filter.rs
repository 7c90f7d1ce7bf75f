//! Which pairs are not reported: none.
//!
//! Rapier 0.27 filters in its narrow phase, and finds the sleeping neighbours that it has to wake through the very pairs
//! that this drops.

use super::super::rapier::dynamics::RigidBodySet;
use super::super::rapier::geometry::{ColliderHandle, ColliderSet};
use crate::pair_tracker::PairChange;

/// A filter that lets all pairs pass.
#[derive(Clone, Default)]
pub(in super::super) struct PairFilter {}

impl PairFilter {
    #[cfg(feature = "serde-serialize")]
    pub(in super::super) fn pairs(&self) -> Vec<[u32; 2]> {
        Vec::new()
    }

    #[cfg(feature = "serde-serialize")]
    pub(in super::super) fn restore(
        withheld: Vec<[u32; 2]>,
        _overlapping: impl Iterator<Item = [u32; 2]>,
    ) -> Result<Self, &'static str> {
        if !withheld.is_empty() {
            return Err("snapshot: a pair is withheld, which Rapier 0.27 has no use for");
        }
        Ok(Self {})
    }

    pub(in super::super) fn sift(
        &mut self,
        _changes: &mut Vec<PairChange>,
        _listed: &[ColliderHandle],
        _removed: &[u32],
        _generations: &[Option<u32>],
        _colliders: &ColliderSet,
        _bodies: &RigidBodySet,
    ) {
    }

    pub(in super::super) fn withholds(&self, _pair: [u32; 2]) -> bool {
        false
    }

    pub(in super::super) fn withheld(&self) -> usize {
        0
    }

    pub(in super::super) fn validate(&self, _pairs: impl Iterator<Item = [u32; 2]>) {}
}
