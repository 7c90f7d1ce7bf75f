//! The result of a comparison.

use super::both::Both;
use super::{Sanity, Timing};
use std::time::Duration;

/// The result of a comparison.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    /// How many steps were simulated.
    pub steps: usize,
    /// How many bodies there were at the end.
    pub bodies: usize,
    /// How many colliders there were at the end.
    pub colliders: usize,
    /// How many pairs were held at the end, without those that the narrow phase drops anyway.
    pub pairs: Both<usize>,
    /// How many pairs were held at the end, all together.
    pub pairs_with_dropped: Both<usize>,
    /// The colliders that touched, in the run that the default drove.
    pub contacts: Tally,
    /// The sensors that were entered, in the run that the default drove.
    pub intersections: Tally,
    /// At how many steps the contacts of both were computed and compared.
    pub contact_checks: usize,
    /// The rays that were cast in the trees of both, and compared.
    pub rays: RayCount,
    /// How many events changed nothing: a pair that was held already, or the end of one that was not.
    pub redundant_events: Both<usize>,
    /// The first difference, with its step; nothing is checked after it.
    pub first_difference: Option<String>,
    /// How long the updates took.
    pub timing: Both<Timing>,
    /// The scene simulated on each broad phase alone, as often as was asked for.
    pub independent: Vec<Both<Independent>>,
    /// The scene simulated once more on the default alone, to time its broad phase; none without independent runs.
    pub clocked: Option<Clocked>,
}

impl Outcome {
    /// Whether the candidate did the same as the default, as far as was checked.
    pub fn is_equal(&self) -> bool {
        self.first_difference.is_none()
    }

    /// How many times as fast as the default the candidate was, over all updates; NaN without updates.
    pub fn ratio(&self) -> f64 {
        self.timing.default.total.as_secs_f64() / self.timing.candidate.total.as_secs_f64()
    }
}

/// A count of something that may happen in each step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// After the last step.
    pub at_end: usize,
    /// Over all steps, each counted at every step at which it was there.
    pub total: usize,
}

impl Tally {
    pub(super) fn record(&mut self, count: usize) {
        self.at_end = count;
        self.total += count;
    }
}

/// How many rays were cast.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RayCount {
    /// All of them.
    pub cast: usize,
    /// Those that hit a collider.
    pub hits: usize,
}

/// The end of a scene that was simulated on one broad phase alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Independent {
    /// The scene in numbers.
    pub sanity: Sanity,
    /// Whether it is still physics, or else the first bound that it breaks.
    pub verdict: Result<(), String>,
    /// How many pairs its own narrow phase holds without a contact or an intersection.
    pub pairs_without_contact: usize,
    /// How long the steps took, with the script, the solver, the queries and everything else.
    pub elapsed: Duration,
    /// How much of that was for rays.
    pub casting: Duration,
    /// The seed of the scene.
    pub seed: u64,
}

impl Both<Independent> {
    /// How many times as fast the whole steps were with the candidate.
    pub fn ratio(&self) -> f64 {
        self.default.elapsed.as_secs_f64() / self.candidate.elapsed.as_secs_f64()
    }
}

/// The times of a scene that was simulated on the default broad phase alone, while a clock watched it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Clocked {
    /// How long the steps took, with the script, the solver, the queries and everything else.
    pub elapsed: Duration,
    /// How much of that the broad phase took.
    pub broad_phase: Duration,
}

impl Clocked {
    /// How many times as fast the whole steps would be on a broad phase that takes no time.
    pub fn limit(&self) -> f64 {
        let rest = self.elapsed.saturating_sub(self.broad_phase);
        self.elapsed.as_secs_f64() / rest.as_secs_f64()
    }
}

#[cfg(test)]
mod tests {
    use super::{Clocked, Duration};

    #[test]
    fn the_limit_is_that_of_a_broad_phase_for_nothing() {
        let [elapsed, broad_phase] = [12, 4].map(Duration::from_millis);
        let clocked = Clocked {
            elapsed,
            broad_phase,
        };
        assert_eq!(clocked.limit(), 1.5);
    }
}
