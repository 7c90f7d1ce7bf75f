//! What a world is judged by at its end: each criterion is a bound on one figure.

use crate::stability::end::{End, Measured};

/// What a world is judged by. Except for the last one, a number that is not finite and a panic are failures as well.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Criterion {
    /// No body is further from where it was put than half a metre, which is half a box.
    StaysInPlace,
    /// The two ends that a joint holds together are nowhere further apart than half a link.
    HoldsTogether,
    /// No body is outside by more than its own size.
    StaysInside,
    /// Nothing panics.
    DoesNotPanic,
}

/// In metres, and in links.
const HALF: f64 = 0.5;

impl Criterion {
    /// Whether a world that ended like this has failed.
    pub(crate) fn is_failed_by(self, end: &End) -> bool {
        match &end.measured {
            Err(_) => true,
            Ok(_) if self == Self::DoesNotPanic => false,
            Ok(measured) => {
                let figure = self.figure(measured);
                measured.not_finite > 0 || figure.is_nan() || figure > self.bound()
            }
        }
    }

    /// What is bounded.
    fn figure(self, measured: &Measured) -> f64 {
        match self {
            Self::StaysInPlace => measured.strayed,
            Self::HoldsTogether => measured.stretch,
            Self::StaysInside => measured.outside as f64,
            Self::DoesNotPanic => measured.not_finite as f64,
        }
    }

    fn bound(self) -> f64 {
        match self {
            Self::StaysInPlace | Self::HoldsTogether => HALF,
            Self::StaysInside | Self::DoesNotPanic => 0.0,
        }
    }

    /// What is a failure, in a few words.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::StaysInPlace => "a body strays by half a box",
            Self::HoldsTogether => "a joint opens by half a link",
            Self::StaysInside => "a body is outside",
            Self::DoesNotPanic => "it panics",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Criterion;
    use crate::stability::end::{End, Measured};

    const ALL: [Criterion; 4] = [
        Criterion::StaysInPlace,
        Criterion::HoldsTogether,
        Criterion::StaysInside,
        Criterion::DoesNotPanic,
    ];

    fn failed(measured: Measured) -> Vec<Criterion> {
        let end = End {
            measured: Ok(measured),
        };
        ALL.into_iter().filter(|c| c.is_failed_by(&end)).collect()
    }

    #[test]
    fn each_has_its_figure() {
        let calm = Measured::default;
        assert_eq!(failed(calm()), []);
        let strayed = |strayed| Measured { strayed, ..calm() };
        let stretched = |stretch| Measured { stretch, ..calm() };
        let outside = |outside| Measured { outside, ..calm() };
        assert_eq!(failed(strayed(0.5)), []);
        assert_eq!(failed(stretched(0.5)), []);
        assert_eq!(failed(strayed(0.51)), [Criterion::StaysInPlace]);
        assert_eq!(failed(stretched(0.51)), [Criterion::HoldsTogether]);
        assert_eq!(failed(outside(1)), [Criterion::StaysInside]);
    }

    #[test]
    fn what_is_not_finite_fails_but_for_panics() {
        let not_finite = Measured {
            not_finite: 1,
            ..Measured::default()
        };
        assert_eq!(failed(not_finite), ALL[..3]);
        let nan = Measured {
            strayed: f64::NAN,
            ..Measured::default()
        };
        assert_eq!(failed(nan), [Criterion::StaysInPlace]);
    }

    #[test]
    fn a_panic_fails_everywhere() {
        let end = End {
            measured: Err("why".to_owned()),
        };
        assert!(
            ALL.into_iter()
                .all(|criterion| criterion.is_failed_by(&end))
        );
    }
}
