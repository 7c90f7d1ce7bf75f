//! The result of one comparison, the same type for both dimensions.

use crate::spread::Spread;
use serde::Serialize;

/// The result of comparing on one scene in one dimension.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Row {
    /// The version.
    pub(super) rapier: &'static str,
    pub(super) scene: String,
    pub(super) dim: u8,
    pub(super) steps: usize,
    pub(super) bodies: usize,
    pub(super) colliders: usize,
    pub(super) seed: u64,
    pub(super) kernel: String,
    pub(super) filter: String,
    pub(super) threads: usize,
    pub(super) equal: bool,
    pub(super) first_difference: Option<String>,
    /// The default's broad-phase time over ours.
    pub(super) ratio: f64,
    /// Pairs held at the end, without those that the narrow phase drops anyway.
    pub(super) pairs: Sides<usize>,
    /// Pairs held at the end, all together.
    pub(super) pairs_with_dropped: Sides<usize>,
    pub(super) contacts: Total,
    pub(super) intersections: Total,
    /// At how many steps the contacts were compared.
    pub(super) contact_checks: usize,
    pub(super) rays: Rays,
    pub(super) redundant_events: Sides<usize>,
    pub(super) broad_phase: Sides<Times>,
    /// Whole steps, on either broad phase alone.
    pub(super) whole_steps: Option<WholeSteps>,
}

/// Whole steps with their queries, on either broad phase alone.
#[derive(Clone, Debug, Serialize)]
pub(super) struct WholeSteps {
    /// The median over all repeats of the mean over their steps.
    pub(super) ms_per_step: Sides<f64>,
    /// The default's time over ours, one of each repeat.
    pub(super) ratio: Spread,
    pub(super) limit: Limit,
    pub(super) repeats: Vec<Repeat>,
}

/// What a broad phase that takes no time would give.
///
/// The times are the means over the steps of one more world on the default alone, with its broad phase clocked.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct Limit {
    pub(super) ms_per_step: f64,
    pub(super) ms_of_broad_phase: f64,
    /// The time of a step over what is left of it without the broad phase.
    pub(super) ratio: f64,
}

/// Two simulations of one seed.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Repeat {
    pub(super) seed: u64,
    pub(super) ratio: f64,
    pub(super) end: Sides<End>,
}

/// The rays whose answers were compared.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Rays {
    /// Cast after each step, beside those of the scene itself.
    pub(super) a_step: usize,
    pub(super) cast: usize,
    pub(super) hits: usize,
}

/// A value for Rapier's broad phase and one for ours.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Sides<T> {
    pub(super) default: T,
    pub(super) ours: T,
}

#[derive(Clone, Debug, Serialize)]
pub(super) struct Total {
    pub(super) at_end: usize,
    pub(super) over_all_steps: usize,
}

/// The times of one broad phase, in milliseconds.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Times {
    pub(super) ms_per_step: f64,
    /// The mean over the updates that had a collider to look at.
    pub(super) ms_per_busy_update: f64,
    pub(super) ms_worst_update: f64,
    pub(super) updates: usize,
    pub(super) busy_updates: usize,
}

/// The end of a simulation on one broad phase alone.
#[derive(Clone, Debug, Serialize)]
pub(super) struct End {
    /// What is wrong with the scene, if anything is.
    pub(super) complaint: Option<String>,
    pub(super) bodies: usize,
    pub(super) asleep: usize,
    /// Bodies that left their container.
    pub(super) outside: usize,
    pub(super) not_finite: usize,
    pub(super) energy: f64,
    pub(super) max_rope_stretch: Option<f64>,
    /// Pairs in its own narrow phase that have neither an active contact nor an intersection.
    pub(super) pairs_without_contact: usize,
    /// The whole step, with the script, the solver, the queries and everything else.
    pub(super) ms_per_step: f64,
    /// What of it is for rays, with the tree that is built for them, if one is.
    pub(super) ms_of_rays: f64,
}
