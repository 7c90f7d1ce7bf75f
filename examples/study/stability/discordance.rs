//! Who fails more often, at one value or at all of them together, which finds what is too little to be told at a single value.
//!
//! A world near its limit is chaotic: the last bit of a number decides whether it holds, and the order of events decides the last
//! bit. So both broad phases are run from the same starts. A start counts if one fails from it and the other does not. If both fail
//! equally often, each is as probable as the other, so the exact sign test tells how probable so many on one side are.

use super::criterion::Criterion;
use super::probe::Probe;
use serde::Serialize;
use statrs::distribution::{Binomial, DiscreteCDF};

/// The probability of a wrong alarm in a whole run of the program, at any of all values, and at all of them together.
const LEVEL: f64 = 0.01;

/// The starts from which one broad phase fails alone. Those with a panic are left out: Rapier's own panics from all
/// starts of some cases, which would outweigh what unisize does in others, and a panic of unisize alone is never sound anyway.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub(crate) struct Discordance {
    /// From which Rapier's own alone fails.
    pub(crate) default: usize,
    /// From which unisize alone fails.
    pub(crate) ours: usize,
}

impl Discordance {
    /// Of one value.
    pub(crate) fn of(probe: &Probe, criterion: Criterion) -> Self {
        let mut discordance = Self::default();
        discordance.count(probe, criterion);
        discordance
    }

    /// Counts the starts of a value.
    pub(crate) fn count(&mut self, probe: &Probe, criterion: Criterion) {
        for (default, ours) in probe.default.iter().zip(&probe.ours) {
            if default.measured.is_err() || ours.measured.is_err() {
                continue;
            }
            match [default, ours].map(|end| criterion.is_failed_by(end)) {
                [true, false] => self.default += 1,
                [false, true] => self.ours += 1,
                _ => {}
            }
        }
    }

    /// How probable it is that so many or more of them fall on unisize, if both fail equally often.
    pub(crate) fn probability(self) -> f64 {
        let starts = (self.default + self.ours) as u64;
        match (Binomial::new(0.5, starts), self.ours.checked_sub(1)) {
            (Ok(on_ours), Some(fewer)) => on_ours.sf(fewer as u64),
            _ => 1.0,
        }
    }

    /// Whether unisize fails more often, and not by chance, if this is one of so many tests.
    pub(crate) fn is_worse(self, tests: usize) -> bool {
        self.probability() * (tests as f64) < LEVEL
    }
}

#[cfg(test)]
mod tests {
    use super::super::end::{End, Measured};
    use super::super::probe::Exact;
    use super::{Criterion, Discordance, Probe};

    fn of(default: usize, ours: usize) -> Discordance {
        Discordance { default, ours }
    }

    #[test]
    fn probabilities_are_those_of_coins() {
        for (discordance, expected) in [
            (of(0, 0), 1.0),
            (of(5, 0), 1.0),
            (of(0, 1), 0.5),
            (of(1, 1), 0.75),
            (of(0, 10), 1.0 / 1024.0),
            (of(1, 9), 11.0 / 1024.0),
        ] {
            let p = discordance.probability();
            assert!((p - expected).abs() < 1e-9, "{discordance:?}: {p}");
        }
        assert!(of(0, 7).is_worse(1));
        assert!(!of(0, 6).is_worse(1));
        assert!(!of(7, 0).is_worse(1));
        assert!(!of(1, 9).is_worse(1));
        // The more tests, the more is a matter of chance.
        assert!(of(0, 14).is_worse(100) && !of(0, 13).is_worse(100));
    }

    #[test]
    fn starts_are_paired() {
        let end = |strayed| End {
            measured: Ok(Measured {
                strayed,
                ..Measured::default()
            }),
        };
        let panic = || End {
            measured: Err("why".to_owned()),
        };
        let probe = Probe {
            default: vec![end(9.0), end(9.0), end(0.0), end(0.0), panic(), end(0.0)],
            ours: vec![end(9.0), end(0.0), end(9.0), end(0.0), end(0.0), panic()],
            in_order: Exact::default(),
            pairs: Exact::default(),
        };
        let mut discordance = Discordance::default();
        for _ in 0..2 {
            discordance.count(&probe, Criterion::StaysInPlace);
        }
        assert_eq!(discordance, of(2, 2));
    }
}
