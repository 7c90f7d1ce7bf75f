//! The results of a trial.

use core::fmt;
use std::time::Duration;

use super::super::rapier::geometry::{BroadPhasePairEvent, ColliderHandle};
use super::super::version;
use crate::clock;
use crate::pair_filter::PairFilter;

/// The levels of the filter, in ascending order.
pub(super) const LEVELS: [PairFilter; 4] = [
    PairFilter::Off,
    PairFilter::Bodies,
    PairFilter::Groups,
    PairFilter::Shapes,
];

/// The results of a [`Trial`](super::Trial). `Display` prints them as a table.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct TrialReport {
    /// The number of updates so far that had colliders to read. Rapier 0.27 makes two updates in each step, one of which usually has none.
    pub updates: u64,
    /// The number of colliders that unisize has now.
    pub colliders: usize,
    /// Rapier's own broad phase.
    pub own: Measured,
    pub(super) levels: [Measured; LEVELS.len()],
    /// The first difference of the pairs, in the first update with one. The trial compares the pairs at the level at which those of unisize
    /// are Rapier's own.
    pub first_difference: Option<Difference>,
}

/// The measurements of one broad phase.
#[derive(Clone, Copy, Debug, Default)]
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
    /// The mean number of pairs after an update, which are left to the narrow phase.
    pub pairs: f64,
    /// The number of bytes that were allocated and not freed; see [`Trial::with_allocated`](super::Trial::with_allocated).
    pub bytes: Option<i64>,
    /// The time of the current update.
    current: Duration,
    /// The sum of the pairs after each update.
    all_pairs: u64,
}

impl Measured {
    pub(super) fn of(level: PairFilter) -> Self {
        Self {
            level: Some(level),
            ..Self::default()
        }
    }

    /// Runs a part of the current update, and adds its time and memory. The memory of events does not count.
    pub(crate) fn run(
        &mut self,
        allocated: Option<fn() -> usize>,
        events: &mut Vec<BroadPhasePairEvent>,
        run: impl FnOnce(&mut Vec<BroadPhasePairEvent>),
    ) {
        let bytes = |events: &Vec<BroadPhasePairEvent>| {
            let of_events = events.capacity() * size_of::<BroadPhasePairEvent>();
            allocated.map(|allocated| allocated() as i64 - of_events as i64)
        };
        let before = bytes(events);
        let began = clock::now();
        run(events);
        self.current += clock::since(began);
        if let (Some(before), Some(after)) = (before, bytes(events)) {
            *self.bytes.get_or_insert(0) += after - before;
        }
    }

    /// Ends an update, after which there are this many pairs. `update` counts from 1, and is `None` if there was nothing to read.
    pub(super) fn end_update(&mut self, update: Option<u64>, pairs: usize) {
        let time = std::mem::take(&mut self.current);
        self.total += time;
        if let Some(update) = update {
            self.all_pairs += pairs as u64;
            self.pairs = self.all_pairs as f64 / update as f64;
            self.mean = self.total.div_f64(update as f64);
            if update > 1 {
                self.longest = self.longest.max(time);
            }
        }
    }
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
}

impl fmt::Display for TrialReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (updates, colliders) = (self.updates, self.colliders);
        writeln!(f, "{updates} updates, {colliders} colliders at the end")?;
        writeln!(f, "{:28}mean, ms  longest, ms      pairs     bytes", "")?;
        for measured in [&self.own].into_iter().chain(&self.levels) {
            writeln!(f, "{measured}")?;
        }
        match self.first_difference {
            None => writeln!(
                f,
                "At level {:?} the pairs were Rapier's own after every update.",
                version::FILTER_OF_OWN
            )?,
            Some(difference) => writeln!(f, "{difference}")?,
        }
        write!(
            f,
            "The default is PairFilter::{:?}. To see what whole steps gain, run the program once on each broad phase (docs/guide.md).",
            version::PAIR_FILTER
        )
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
        let holder = ["unisize", "Rapier's own"][usize::from(self.is_missing)];
        write!(
            f,
            "DIFFERENT: after update {} only {holder} held the pair of {first:?} and {second:?}. \
             Please report it, unless the margin is another than Rapier's, or a collider at rest has got another contact skin or other \
             active collision types.",
            self.update
        )
    }
}
