//! What a world is judged by at its end: each criterion is a bound on one figure.

use crate::end::{End, Measured};

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
    pub(crate) fn figure(self, measured: &Measured) -> f64 {
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

    /// What is a failure, as a sentence.
    pub(crate) fn sentence(self) -> &'static str {
        match self {
            Self::StaysInPlace => {
                "A run fails if a body ends more than half a box from where it was put, or is not finite."
            }
            Self::HoldsTogether => {
                "A run fails if the two ends of a joint are more than half a link apart at the end, or not finite."
            }
            Self::StaysInside => {
                "A run fails if a body ends outside by more than its own size, or is not finite."
            }
            Self::DoesNotPanic => "A run fails if it panics.",
        }
    }

    /// The heading of the figure.
    pub(crate) fn heading(self) -> &'static str {
        match self {
            Self::StaysInPlace => "farthest body, boxes",
            Self::HoldsTogether => "widest joint, links",
            Self::StaysInside => "bodies outside",
            Self::DoesNotPanic => "bodies not finite",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Criterion;
    use crate::end::{End, Measured};

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
        let near = Measured {
            strayed: 0.5,
            stretch: 0.5,
            ..calm()
        };
        assert_eq!(failed(near), []);
        for (measured, criterion) in [
            (
                Measured {
                    strayed: 0.51,
                    ..calm()
                },
                Criterion::StaysInPlace,
            ),
            (
                Measured {
                    stretch: 0.51,
                    ..calm()
                },
                Criterion::HoldsTogether,
            ),
            (
                Measured {
                    outside: 1,
                    ..calm()
                },
                Criterion::StaysInside,
            ),
        ] {
            assert_eq!(failed(measured), [criterion]);
        }
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
