//! What Rapier 0.36 has in its own way: vectors of glam.

use super::rapier::counters::Counters;
use super::rapier::math;
use super::rapier::prelude::*;

pub(super) type Vector = math::Vector;
pub(super) type Pose = math::Pose;

/// With this filter, unisize has all pairs that Rapier's own broad phase has.
#[cfg(feature = "check")]
pub(super) const ALL_PAIRS: unisize::PairFilter = unisize::PairFilter::Groups;

/// The origin of a pose.
pub(super) fn origin(pose: &Pose) -> Vector {
    pose.translation
}

/// Whether the solver sees a contact of this pair.
pub(super) fn touches(pair: &ContactPair) -> bool {
    pair.has_any_active_contact()
}

/// The milliseconds of the broad phase in the last step, at the end of which it is given the boxes of what has moved.
pub(super) fn broad_phase_ms(counters: &Counters) -> f64 {
    counters.cd.broad_phase_time.time_ms() + counters.cd.final_broad_phase_time.time_ms()
}
