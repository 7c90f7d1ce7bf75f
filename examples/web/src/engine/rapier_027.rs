//! What Rapier 0.27 has in its own way: vectors of nalgebra.

use super::rapier::counters::Counters;
use super::rapier::math::{self, Isometry};
use super::rapier::prelude::*;

pub(super) type Vector = math::Vector<Real>;
pub(super) type Pose = Isometry<Real>;

/// With this filter, unisize has all pairs that Rapier's own broad phase has.
#[cfg(feature = "check")]
pub(super) const ALL_PAIRS: unisize::PairFilter = unisize::PairFilter::Off;

/// The origin of a pose.
pub(super) fn origin(pose: &Pose) -> Vector {
    pose.translation.vector
}

/// Whether the solver sees a contact of this pair.
pub(super) fn touches(pair: &ContactPair) -> bool {
    pair.has_any_active_contact
}

/// The milliseconds of the broad phase in the last step.
pub(super) fn broad_phase_ms(counters: &Counters) -> f64 {
    counters.cd.broad_phase_time.time_ms()
}
