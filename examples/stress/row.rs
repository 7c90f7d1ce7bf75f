//! The outcome of a case in one flavour.

use crate::case::Case;
use crate::criterion::Criterion;
use crate::end::End;
use crate::verdict::{Failures, Verdict};

/// The outcome of a case in one flavour.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    pub(crate) dim: u8,
    pub(crate) case: Case,
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
#[derive(Clone, Debug, Default, PartialEq, Eq)]
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

impl Row {
    pub(crate) fn criterion(&self) -> Criterion {
        self.case.family.criterion()
    }

    /// The failures on Rapier's own broad phase, and on unisize.
    pub(crate) fn failures(&self) -> [Failures; 2] {
        [&self.default, &self.ours].map(|ends| {
            let failed = ends.iter().filter(|end| self.criterion().is_failed_by(end));
            Failures {
                failed: failed.count(),
                runs: ends.len(),
            }
        })
    }

    /// The medians of what is judged; NaN where it is not finite or the run has panicked.
    pub(crate) fn medians(&self) -> [f64; 2] {
        [&self.default, &self.ours].map(|ends| {
            let figure = |end: &End| match &end.measured {
                Ok(measured) => self.criterion().figure(measured),
                Err(_) => f64::NAN,
            };
            let mut figures: Vec<_> = ends.iter().map(figure).collect();
            figures.sort_by(f64::total_cmp);
            figures.get(figures.len() / 2).copied().unwrap_or(f64::NAN)
        })
    }

    /// Who fails, if this is one of so many cases.
    pub(crate) fn verdict(&self, cases: usize) -> Verdict {
        let [default, ours] = self.failures();
        Verdict::of(default, ours, cases)
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
    pub(crate) fn is_sound(&self, cases: usize) -> bool {
        self.verdict(cases) != Verdict::OursAlone
            && self.panic_alone().is_none()
            && self.in_order.difference.is_none()
            && self.pairs.difference.is_none()
    }
}

#[cfg(test)]
mod tests {
    use super::{End, Exact, Row, Verdict};
    use crate::end::Measured;
    use crate::family::Family;

    #[test]
    fn one_panic_alone_is_never_sound() {
        let calm = End {
            measured: Ok(Measured::default()),
        };
        let panic = End {
            measured: Err("why".to_owned()),
        };
        let row = |default: &End, ours: &End| Row {
            dim: 2,
            case: Family::Extremes.cases().swap_remove(0),
            default: vec![calm.clone(), default.clone()],
            ours: vec![calm.clone(), ours.clone()],
            in_order: Exact::default(),
            pairs: Exact::default(),
        };
        assert!(row(&calm, &calm).is_sound(1));
        assert!(row(&panic, &panic).is_sound(1));
        assert!(row(&panic, &calm).is_sound(1));
        let alone = row(&calm, &panic);
        assert_eq!(alone.verdict(1), Verdict::Alike);
        assert_eq!(alone.panic_alone(), Some("why"));
        assert!(!alone.is_sound(1));
    }
}
