//! The results of a trial.

use core::fmt;
use std::time::Duration;

use super::super::rapier::geometry::ColliderHandle;
use super::LEVELS;
use crate::pair_filter::PairFilter;

/// The share of the time by which another level of the filter must beat the default to be recommended.
const WORTHWHILE: f64 = 0.03;

/// The results of a [`Trial`](super::Trial). `Display` prints them as a table and a recommendation.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct TrialReport {
    /// The number of updates so far that had colliders to read. Rapier 0.27 makes two updates in each step, one of which usually has none.
    pub updates: u64,
    /// The number of colliders that unisize has now.
    pub colliders: usize,
    /// The largest number of threads that have shared an update of unisize in this program; 1 if no update was worth it.
    pub threads: usize,
    /// The wall-clock time of the trial without that of Rapier's own broad phase.
    pub overhead: Duration,
    /// Rapier's own broad phase.
    pub own: Measured,
    pub(super) levels: [Measured; LEVELS.len()],
    /// The default level of the filter with this version of Rapier.
    pub default_level: PairFilter,
    /// The level at which the pairs of unisize are those of Rapier's own broad phase. The trial compares the pairs at this level.
    pub compared_level: PairFilter,
    /// The first difference of the pairs, in the first update with one.
    pub first_difference: Option<Difference>,
    pub(super) steps: Option<Steps>,
}

/// The time of all steps on Rapier's own broad phase.
#[derive(Clone, Copy, Debug)]
pub(super) struct Steps {
    total: Duration,
    /// The part of the narrow phase.
    narrow_phase: Option<Duration>,
}

/// The measurements of one broad phase.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Measured {
    /// The level of the filter; `None` for Rapier's own broad phase.
    pub level: Option<PairFilter>,
    /// The wall-clock time of all updates, including the boxes that were set between them.
    pub total: Duration,
    /// The mean time per update.
    pub mean: Duration,
    /// The longest time of an update. The first one, in which everything is new, does not count.
    pub longest: Duration,
    /// The mean number of pairs after an update.
    pub pairs: f64,
    /// The number of bytes that were allocated and not freed; see [`Trial::with_allocated`](super::Trial::with_allocated).
    pub bytes: Option<i64>,
}

/// A pair that the narrow phase would not drop, and that only one of two broad phases had.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Difference {
    /// The number of the update, counting from 1.
    pub update: u64,
    /// The two colliders.
    pub colliders: [ColliderHandle; 2],
    /// Whether Rapier's own broad phase had the pair, and unisize did not.
    pub is_missing: bool,
}

impl TrialReport {
    /// Returns whether the pairs were the same after every update.
    pub fn pairs_match(&self) -> bool {
        self.first_difference.is_none()
    }

    /// Returns the measurements of unisize at each level of the filter, in ascending order.
    pub fn levels(&self) -> &[Measured] {
        &self.levels
    }

    /// Returns the measurements of unisize at one level of the filter.
    pub fn level(&self, level: PairFilter) -> &Measured {
        &self.levels[level as usize]
    }

    /// Returns the report with the time of whole steps, from which it computes speedups.
    ///
    /// `elapsed` is the wall-clock time of all steps since the trial began. It includes the trial, whose [`overhead`](Self::overhead) the report
    /// subtracts. `narrow_phase` is the part that the narrow phase took: the sum of `PhysicsPipeline::counters.narrow_phase_time_ms()` over all
    /// steps, with Rapier's feature `profiler`. Without it, there are lower bounds but no estimates.
    pub fn with_steps(self, elapsed: Duration, narrow_phase: impl Into<Option<Duration>>) -> Self {
        // A step takes no less time than its parts.
        let narrow_phase = narrow_phase.into();
        let parts = self
            .own
            .total
            .saturating_add(narrow_phase.unwrap_or_default());
        let total = elapsed.saturating_sub(self.overhead).max(parts);
        let steps = Some(Steps {
            total,
            narrow_phase,
        });
        Self { steps, ..self }
    }

    /// Returns a lower bound for the speedup of whole steps at one level of the filter; `None` without [`with_steps`](Self::with_steps).
    ///
    /// The bound exchanges only the time of the broad phases. Fewer pairs also save time in the narrow phase. Queries do not count.
    pub fn min_speedup(&self, level: PairFilter) -> Option<f64> {
        let steps = self.steps?.total;
        Some(speedup(
            steps,
            steps - self.own.total + self.level(level).total,
        ))
    }

    /// Returns an estimate of the speedup of whole steps at one level of the filter; `None` without the time of the narrow phase (see
    /// [`with_steps`](Self::with_steps)).
    ///
    /// The estimate assumes that each pair costs the narrow phase the same time. A pair without contact costs less than one with a contact, so
    /// the speedup is between [`min_speedup`](Self::min_speedup) and the estimate if unisize leaves out pairs.
    pub fn estimated_speedup(&self, level: PairFilter) -> Option<f64> {
        let Steps {
            total,
            narrow_phase,
        } = self.steps?;
        let level = self.level(level);
        let narrow_phase = narrow_phase?;
        let share = match self.own.pairs > 0.0 {
            true => level.pairs / self.own.pairs,
            false => 1.0,
        };
        let rest = total - self.own.total - narrow_phase;
        let exchanged = rest + level.total + narrow_phase.mul_f64(share);
        Some(speedup(total, exchanged))
    }

    /// Returns the level of the filter with which the program takes least time, or `None` if Rapier's own broad phase is as fast.
    ///
    /// It goes by the [estimate](Self::estimated_speedup) if there is one, else by the [lower bound](Self::min_speedup), else by the time of the
    /// updates. Without an estimate, it does not recommend a level with more pairs than the default. A level other than the default must gain 3 %
    /// over it. [`PairFilter`] says what changes at other levels.
    pub fn recommended_filter(&self) -> Option<PairFilter> {
        let gain = |level: PairFilter| {
            let of_steps = self.estimated_speedup(level).or(self.min_speedup(level));
            of_steps.unwrap_or_else(|| speedup(self.own.total, self.level(level).total))
        };
        let pairs = |level: PairFilter| self.level(level).pairs;
        let default = self.default_level;
        // Without the time of the narrow phase, its price for more pairs is unknown.
        let is_estimated = self.estimated_speedup(default).is_some();
        let allowed = LEVELS.into_iter();
        let allowed = allowed.filter(|&level| is_estimated || pairs(level) <= pairs(default));
        let best = allowed.fold(default, |best, level| {
            if gain(level) > gain(best) {
                level
            } else {
                best
            }
        });
        let is_better = gain(best) > gain(default) * (1.0 + WORTHWHILE);
        let recommended = if is_better { best } else { default };
        // Fewer pairs may pay for a slower update.
        let may_save_more =
            !is_estimated && pairs(recommended) < self.own.pairs * (1.0 - WORTHWHILE);
        (gain(recommended) > 1.0 || may_save_more).then_some(recommended)
    }
}

/// The time before divided by the time after; 1 where no time passed, as on a platform without a clock.
fn speedup(before: Duration, after: Duration) -> f64 {
    match after.is_zero() {
        true => 1.0,
        false => before.as_secs_f64() / after.as_secs_f64(),
    }
}

impl fmt::Display for TrialReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            updates,
            colliders,
            threads,
            ..
        } = self;
        let plural = if *threads == 1 { "" } else { "s" };
        writeln!(
            f,
            "{updates} updates, {colliders} colliders at the end, unisize on {threads} thread{plural}"
        )?;
        writeln!(f, "{:28}mean, ms  longest, ms      pairs     bytes", "")?;
        for measured in [&self.own].into_iter().chain(&self.levels) {
            writeln!(f, "{measured}")?;
        }
        let overhead = self.overhead.as_secs_f64() * 1e3 / self.updates.max(1) as f64;
        writeln!(f, "The trial adds {overhead:.3} ms to an update.")?;
        match self.first_difference {
            None => writeln!(
                f,
                "At level {:?} the pairs were Rapier's own after every update.",
                self.compared_level
            )?,
            Some(difference) => writeln!(f, "{difference}")?,
        }
        let recommended = self.recommended_filter();
        let level = recommended.unwrap_or(self.default_level);
        if let Some(least) = self.min_speedup(level) {
            write!(
                f,
                "Speedup of whole steps with PairFilter::{level:?}: at least {least:.2}"
            )?;
            if let Some(estimate) = self.estimated_speedup(level) {
                write!(f, ", by the time of the narrow phase up to {estimate:.2}")?;
            }
            writeln!(f, ".")?;
        }
        match recommended {
            None => write!(f, "Stay with Rapier's own: unisize gains nothing here."),
            Some(level) if level == self.default_level => {
                write!(f, "Recommended: the default, PairFilter::{level:?}.")
            }
            Some(level) => write!(
                f,
                "Recommended: PairFilter::{level:?}. The default is {:?}, so read first what the level changes.",
                self.default_level
            ),
        }
    }
}

impl fmt::Display for Measured {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = match self.level {
            None => "Rapier's own".to_owned(),
            Some(level) => format!("unisize, PairFilter::{level:?}"),
        };
        let [mean, longest] = [self.mean, self.longest].map(|time| time.as_secs_f64() * 1e3);
        let bytes = self.bytes.map_or("-".to_owned(), |bytes| bytes.to_string());
        let pairs = self.pairs;
        write!(
            f,
            "{name:28}{mean:8.3}  {longest:11.3}  {pairs:9.0}  {bytes:>8}"
        )
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [first, second] = self.colliders;
        let holder = if self.is_missing {
            "Rapier's own"
        } else {
            "unisize"
        };
        write!(
            f,
            "DIFFERENT: after update {} only {holder} held the pair of {first:?} and {second:?}. \
             Please report it, unless the margin is another than Rapier's, or a collider at rest has got another contact skin or other \
             active collision types.",
            self.update
        )
    }
}
