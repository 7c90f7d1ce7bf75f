//! The results of a trial.

use core::fmt;
use std::time::Duration;

use super::super::rapier::geometry::ColliderHandle;
use super::LEVELS;
use crate::pair_filter::PairFilter;

/// The share of the pairs by which two levels of the filter must differ to matter.
const WORTHWHILE: f64 = 0.05;

/// The results of a [`Trial`](super::Trial). `Display` prints them as a table and a recommendation.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct TrialReport {
    /// The number of updates so far that had colliders to read. Rapier 0.27 makes two updates in each step, one of which usually has none.
    pub updates: u64,
    /// The number of colliders that unisize has now.
    pub colliders: usize,
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

    /// Returns the recommended level of the filter, or `None` if Rapier's own broad phase is as fast and has as few pairs.
    ///
    /// This is the default level, unless another level has at least a twentieth fewer pairs. Then it is the lowest level whose number of pairs is
    /// within a twentieth of the smallest. [`PairFilter`] says what changes at levels other than the default.
    pub fn recommended_filter(&self) -> Option<PairFilter> {
        let fewest = self.levels.iter().map(|level| level.pairs);
        let fewest = fewest.fold(f64::INFINITY, f64::min);
        let is_few = |pairs: f64| pairs * (1.0 - WORTHWHILE) <= fewest;
        let default = self.level(self.default_level);
        let lowest = self.levels.iter().find(|level| is_few(level.pairs));
        let recommended = match lowest {
            Some(lowest) if !is_few(default.pairs) => lowest,
            _ => default,
        };
        let saves_pairs = recommended.pairs < self.own.pairs * (1.0 - WORTHWHILE);
        let pays = recommended.mean < self.own.mean || saves_pairs;
        recommended.level.filter(|_| pays)
    }

    /// Returns a lower bound of the speedup of whole steps at one level of the filter. `steps` is the time of all steps so far on Rapier's own
    /// broad phase; if the trial ran within the steps, subtract its [`overhead`](Self::overhead).
    ///
    /// The bound counts only the time of the broad phases. Fewer pairs also save time in the narrow phase. Queries do not count. The result is NaN
    /// if neither steps nor updates took any time.
    pub fn min_speedup(&self, steps: Duration, level: PairFilter) -> f64 {
        // Steps include their broad phase.
        let steps = steps.max(self.own.total);
        let exchanged = steps - self.own.total + self.level(level).total;
        steps.as_secs_f64() / exchanged.as_secs_f64()
    }
}

impl fmt::Display for TrialReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            updates, colliders, ..
        } = self;
        writeln!(f, "{updates} updates, {colliders} colliders at the end")?;
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
        match self.recommended_filter() {
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
             Please report it, unless the margin is another than Rapier's.",
            self.update
        )
    }
}
