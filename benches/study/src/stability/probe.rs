//! The outcome of a case in one flavour.
//!
//! A world near its limit is chaotic: the last bit of a number decides whether it holds, and the order of events decides the last
//! bit. So both broad phases run from the same starts. A start counts if exactly one of the two fails from it.

use crate::statistics::sign_test;

/// The probability of a wrong alarm in a whole run of the program, at any of all values, and at all of them together.
const LEVEL: f64 = 0.01;

/// How a world ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum End {
    Holds,
    Fails,
    /// With the message of the panic.
    Panics(String),
}

/// The result of two worlds side by side, with the events of both in order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Found {
    /// The same pairs after each step, and the same bodies to the bit at the end.
    Equal,
    Difference(String),
    /// There is a difference, but none if a step asks the tree of Rapier's own broad phase.
    ByTree,
    /// Rapier's own broad phase panicked, so that there is nothing to compare with.
    Panic,
}

impl Found {
    /// Adds the seed of the run to a difference.
    pub(crate) fn of_seed(self, seed: u64) -> Self {
        match self {
            Self::Difference(difference) => Self::Difference(format!("seed {seed}: {difference}")),
            other => other,
        }
    }
}

/// The number of runs with each result.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Equality {
    pub(crate) equal: usize,
    pub(crate) differing: usize,
    pub(crate) by_tree: usize,
    pub(crate) panicked: usize,
    /// The first difference.
    pub(crate) difference: Option<String>,
}

impl FromIterator<Found> for Equality {
    fn from_iter<I: IntoIterator<Item = Found>>(runs: I) -> Self {
        let mut equality = Self::default();
        for found in runs {
            match found {
                Found::Equal => equality.equal += 1,
                Found::ByTree => equality.by_tree += 1,
                Found::Panic => equality.panicked += 1,
                Found::Difference(difference) => {
                    equality.differing += 1;
                    equality.difference.get_or_insert(difference);
                }
            }
        }
        equality
    }
}

/// The starts from which one broad phase fails alone. Starts with a panic do not count: Rapier's own panics from all starts of some
/// cases, which would outweigh the others, and a panic of unisize alone is never sound anyway.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Alone {
    pub(crate) default: usize,
    pub(crate) ours: usize,
}

impl Alone {
    /// Of several cases.
    pub(crate) fn of<'a>(probes: impl Iterator<Item = &'a Probe>) -> Self {
        let ends = probes.flat_map(|probe| &probe.ends);
        ends.fold(Self::default(), |mut alone, ends| {
            alone.default += usize::from(*ends == [End::Fails, End::Holds]);
            alone.ours += usize::from(*ends == [End::Holds, End::Fails]);
            alone
        })
    }

    /// The p-value of unisize's failures, if both fail equally often.
    pub(crate) fn probability(self) -> f64 {
        sign_test(self.ours, self.default)
    }

    /// Whether unisize fails significantly more often, in one of this many tests.
    pub(crate) fn is_worse(self, tests: usize) -> bool {
        self.probability() * (tests as f64) < LEVEL
    }

    /// The number of starts from which unisize has to fail alone to be noticed in one of this many tests.
    pub(crate) fn noticed(tests: usize) -> usize {
        let would_be = |&ours: &usize| Self { default: 0, ours }.is_worse(tests);
        (1..).find(would_be).expect("many enough always are")
    }
}

/// The outcome of a case in one flavour.
#[derive(Clone, Debug)]
pub(crate) struct Probe {
    /// From each start: how it ended on Rapier's own broad phase, and on unisize.
    pub(crate) ends: Vec<[End; 2]>,
    pub(crate) equality: Equality,
}

impl Probe {
    /// The number of failures on Rapier's own broad phase, and on unisize. A panic is a failure.
    pub(crate) fn failures(&self) -> [usize; 2] {
        let fails = |side: usize| move |ends: &&[End; 2]| ends[side] != End::Holds;
        [0, 1].map(|side| self.ends.iter().filter(fails(side)).count())
    }

    pub(crate) fn alone(&self) -> Alone {
        Alone::of(std::iter::once(self))
    }

    /// The message of unisize's first panic from a start from which Rapier's own does not panic.
    pub(crate) fn panic_alone(&self) -> Option<&str> {
        self.ends.iter().find_map(|ends| match ends {
            [End::Holds | End::Fails, End::Panics(message)] => Some(message.as_str()),
            _ => None,
        })
    }

    /// Whether unisize does not fail significantly more often, at one of this many values, never panics alone, and is equal to Rapier's own
    /// where both are compared.
    pub(crate) fn is_sound(&self, values: usize) -> bool {
        !self.alone().is_worse(values)
            && self.panic_alone().is_none()
            && self.equality.differing == 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn probe(ends: [[End; 2]; 2]) -> Probe {
        Probe {
            ends: ends.into(),
            equality: Equality::default(),
        }
    }

    #[test]
    fn starts_are_paired() {
        use End::{Fails, Holds};
        let panics = || End::Panics("why".to_owned());
        let of = |ends| {
            let probe = probe(ends);
            (probe.alone(), probe.failures())
        };
        let alone = |default, ours| Alone { default, ours };
        let found = of([[Fails, Fails], [Fails, Holds]]);
        assert_eq!(found, (alone(1, 0), [2, 1]));
        let found = of([[Holds, Fails], [Holds, Holds]]);
        assert_eq!(found, (alone(0, 1), [0, 1]));
        let found = of([[panics(), Holds], [Holds, panics()]]);
        assert_eq!(found, (alone(0, 0), [1, 1]));
    }

    #[test]
    fn one_panic_alone_is_never_sound() {
        let panics = || End::Panics("why".to_owned());
        let calm = || [End::Holds, End::Holds];
        assert!(probe([calm(), calm()]).is_sound(1));
        assert!(probe([calm(), [panics(), panics()]]).is_sound(1));
        assert!(probe([calm(), [panics(), End::Holds]]).is_sound(1));
        let alone = probe([calm(), [End::Holds, panics()]]);
        assert!(!alone.alone().is_worse(1));
        assert_eq!(alone.panic_alone(), Some("why"));
        assert!(!alone.is_sound(1));
    }

    #[test]
    fn the_more_tests_the_more_is_a_matter_of_chance() {
        let ours = |ours| Alone { default: 0, ours };
        assert!(ours(7).is_worse(1) && !ours(6).is_worse(1));
        assert!(ours(14).is_worse(100) && !ours(13).is_worse(100));
        assert_eq!([1, 100].map(Alone::noticed), [7, 14]);
    }
}
