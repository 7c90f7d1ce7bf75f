//! Rapier 0.36: vectors of glam.

use crate::rapier::counters::Counters;
use crate::rapier::math;
use crate::rapier::prelude::*;

pub(crate) type Vector = math::Vector;
pub(crate) type Pose = math::Pose;

/// The filter with which unisize has all pairs of Rapier's own broad phase.
#[cfg(feature = "check")]
pub(crate) const ALL_PAIRS: unisize::PairFilter = unisize::PairFilter::Groups;

pub(crate) fn translation(pose: &Pose) -> Vector {
    pose.translation
}

/// Whether the solver receives a contact of this pair.
pub(crate) fn is_touching(pair: &ContactPair) -> bool {
    pair.has_any_active_contact()
}

/// The milliseconds of the broad phase in the last step, with the boxes that it receives at the end of the step.
pub(crate) fn broad_phase_ms(counters: &Counters) -> f64 {
    counters.cd.broad_phase_time.time_ms() + counters.cd.final_broad_phase_time.time_ms()
}
