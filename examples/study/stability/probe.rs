//! The outcome of a case in one flavour.

use super::criterion::Criterion;
use super::discordance::Discordance;
use super::end::End;
use serde::Serialize;
use std::ops::Range;

/// The starts of a case.
#[derive(Clone, Debug)]
pub(crate) struct Seeds {
    pub(crate) all: Range<u64>,
    /// Those that are checked exactly as well.
    pub(crate) exact: Range<u64>,
}

/// The outcome of a case in one flavour.
#[derive(Clone, Debug)]
pub(crate) struct Probe {
    /// On Rapier's own broad phase, one for each start.
    pub(crate) default: Vec<End>,
    /// On unisize.
    pub(crate) ours: Vec<End>,
    /// Whether both end alike to the bit if their events are in order.
    pub(crate) in_order: Exact,
    /// Whether both hold the same pairs after each step of one world.
    pub(crate) pairs: Exact,
}

/// The outcome of a check that leaves nothing to chance.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub(crate) struct Exact {
    /// In how many runs there was nothing to tell apart.
    pub(crate) equal: usize,
    /// In how many runs there was a difference.
    pub(crate) differing: usize,
    /// In how many runs Rapier's own broad phase panicked, so that there is nothing to compare with.
    pub(crate) panicked: usize,
    /// In how many runs there was a difference, and none once a step found the tree of Rapier's own.
    pub(crate) by_tree: usize,
    /// The first difference.
    pub(crate) difference: Option<String>,
}

/// The outcome of such a check in one run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Found {
    Equal,
    Difference(String),
    /// Rapier's own broad phase panicked.
    Panic,
    /// There is a difference, and none once a step finds the tree of Rapier's own.
    ByTree,
}

impl Found {
    /// The same with the seed of the run.
    pub(crate) fn of_seed(self, seed: u64) -> Self {
        match self {
            Self::Difference(difference) => Self::Difference(format!("seed {seed}: {difference}")),
            other => other,
        }
    }
}

impl Exact {
    /// All runs.
    pub(crate) fn runs(&self) -> usize {
        self.equal + self.differing + self.panicked + self.by_tree
    }
}

impl FromIterator<Found> for Exact {
    fn from_iter<I: IntoIterator<Item = Found>>(runs: I) -> Self {
        let mut exact = Self::default();
        for found in runs {
            match found {
                Found::Equal => exact.equal += 1,
                Found::Panic => exact.panicked += 1,
                Found::ByTree => exact.by_tree += 1,
                Found::Difference(difference) => {
                    exact.differing += 1;
                    exact.difference.get_or_insert(difference);
                }
            }
        }
        exact
    }
}

impl Probe {
    /// From how many starts it failed on Rapier's own broad phase, and on unisize.
    pub(crate) fn failures(&self, criterion: Criterion) -> [usize; 2] {
        [&self.default, &self.ours].map(|ends| {
            let failed = ends.iter().filter(|end| criterion.is_failed_by(end));
            failed.count()
        })
    }

    /// Whether unisize fails alone, if this is one of so many values.
    pub(crate) fn ours_fails_alone(&self, criterion: Criterion, values: usize) -> bool {
        Discordance::of(self, criterion).is_worse(values)
    }

    /// What unisize said at its first panic from a start from which Rapier's own does not panic.
    pub(crate) fn panic_alone(&self) -> Option<&str> {
        let mut starts = self.default.iter().zip(&self.ours);
        starts.find_map(
            |(default, ours)| match (&default.measured, &ours.measured) {
                (Ok(_), Err(message)) => Some(message.as_str()),
                _ => None,
            },
        )
    }

    /// Whether unisize neither fails alone nor panics alone, from however few starts, and does exactly what Rapier's does where that
    /// is asked.
    pub(crate) fn is_sound(&self, criterion: Criterion, values: usize) -> bool {
        !self.ours_fails_alone(criterion, values)
            && self.panic_alone().is_none()
            && self.in_order.difference.is_none()
            && self.pairs.difference.is_none()
    }
}

#[cfg(test)]
mod tests {
    use super::super::end::Measured;
    use super::{Criterion, End, Exact, Probe};

    #[test]
    fn one_panic_alone_is_never_sound() {
        const CRITERION: Criterion = Criterion::DoesNotPanic;
        let calm = End {
            measured: Ok(Measured::default()),
        };
        let panic = End {
            measured: Err("why".to_owned()),
        };
        let probe = |default: &End, ours: &End| Probe {
            default: vec![calm.clone(), default.clone()],
            ours: vec![calm.clone(), ours.clone()],
            in_order: Exact::default(),
            pairs: Exact::default(),
        };
        assert!(probe(&calm, &calm).is_sound(CRITERION, 1));
        assert!(probe(&panic, &panic).is_sound(CRITERION, 1));
        assert!(probe(&panic, &calm).is_sound(CRITERION, 1));
        let alone = probe(&calm, &panic);
        assert!(!alone.ours_fails_alone(CRITERION, 1));
        assert_eq!(alone.panic_alone(), Some("why"));
        assert!(!alone.is_sound(CRITERION, 1));
    }
}
