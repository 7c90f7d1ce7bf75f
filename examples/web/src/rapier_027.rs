//! Rapier 0.27: vectors of nalgebra.

use crate::rapier::counters::Counters;
use crate::rapier::math::{self, Isometry};
use crate::rapier::prelude::*;

pub(crate) type Vector = math::Vector<Real>;
pub(crate) type Pose = Isometry<Real>;

/// The filter with which unisize has all pairs of Rapier's own broad phase.
#[cfg(feature = "check")]
pub(crate) const ALL_PAIRS: unisize::PairFilter = unisize::PairFilter::Off;

pub(crate) fn translation(pose: &Pose) -> Vector {
    pose.translation.vector
}

/// Whether the solver receives a contact of this pair.
pub(crate) fn is_touching(pair: &ContactPair) -> bool {
    pair.has_any_active_contact
}

/// The milliseconds of the broad phase in the last step.
pub(crate) fn broad_phase_ms(counters: &Counters) -> f64 {
    counters.cd.broad_phase_time.time_ms()
}
