//! What a trial has found out.

use core::fmt;
use std::time::Duration;

use super::super::rapier::geometry::ColliderHandle;
use super::LEVELS;
use crate::pair_filter::PairFilter;

/// The share of pairs by which a level of the filter must differ from another for it to matter.
const WORTHWHILE: f64 = 0.05;

/// What a [`Trial`](super::Trial) has found out. It prints itself as a table and some sentences.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct TrialReport {
    /// Updates so far that had colliders to look at. Rapier 0.27 makes two in each step, of which one is mostly without any.
    pub updates: u64,
    /// Colliders that unisize holds now.
    pub colliders: usize,
    /// The wall-clock time of all that the trial does besides running Rapier's own broad phase.
    pub overhead: Duration,
    /// Rapier's own broad phase.
    pub own: Measured,
    pub(super) levels: [Measured; LEVELS.len()],
    /// The level that unisize has by default with this version of Rapier.
    pub default_level: PairFilter,
    /// The level at which the pairs are Rapier's own: these were compared.
    pub compared_level: PairFilter,
    /// The first pair that only one of the two held, in the first update where there was one.
    pub first_difference: Option<Difference>,
}

/// What one of the broad phases took, and what it held.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Measured {
    /// The level of the filter; `None` for Rapier's own.
    pub level: Option<PairFilter>,
    /// The wall-clock time of all updates, with the boxes that were handed over for them.
    pub total: Duration,
    /// Its mean for an update.
    pub mean: Duration,
    /// The longest time of an update other than the first one, in which everything is new.
    pub longest: Duration,
    /// The mean number of pairs after an update.
    pub pairs: f64,
    /// Bytes allocated and not given back; see [`Trial::with_allocated`](super::Trial::with_allocated).
    pub bytes: Option<i64>,
}

/// A pair that only one of two broad phases held, although the narrow phase would look at it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Difference {
    /// The number of the update, the first one being 1.
    pub update: u64,
    /// The two colliders.
    pub colliders: [ColliderHandle; 2],
    /// Whether it was unisize that did not hold it.
    pub is_missing: bool,
}

impl TrialReport {
    /// Whether the pairs were the same after every update.
    pub fn pairs_match(&self) -> bool {
        self.first_difference.is_none()
    }

    /// unisize at each level of the filter, from the one that leaves out nothing.
    pub fn levels(&self) -> &[Measured] {
        &self.levels
    }

    /// unisize at this level.
    pub fn level(&self, level: PairFilter) -> &Measured {
        &self.levels[level as usize]
    }

    /// The level of the filter that the trial recommends: the default, or the lowest one with nearly as few pairs as any if that is fewer by a twentieth
    /// than with the default. `None` if Rapier's own broad phase is as fast, and as few pairs are left.
    ///
    /// What a level other than the default changes is told by [`PairFilter`].
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

    /// How many times as fast whole steps would be at least with this level of the filter, if all steps so far take this long on Rapier's
    /// own broad phase: without the [`overhead`](Self::overhead), where the trial ran within them. What the narrow phase saves with fewer
    /// pairs comes on top. Queries are not in it. NaN if neither steps nor updates have taken any time.
    pub fn min_speedup(&self, steps: Duration, level: PairFilter) -> f64 {
        // A step takes no less than its broad phase.
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
