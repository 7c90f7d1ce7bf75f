//! The families of cases: in each, one thing goes from harmless to hopeless.

use crate::case::{Case, Setup};
use crate::criterion::Criterion;

/// Cases that differ in one thing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Family {
    Stacks,
    MassRatios,
    Chains,
    TimeSteps,
    Offsets,
    SizesByDefault,
    SizesTold,
    Spins,
    ShotsWithoutCcd,
    ShotsWithCcd,
    Extremes,
}

/// The usual time step, in seconds.
const DT: f64 = 1.0 / 60.0;

/// Links of a chain.
const LINKS: usize = 100;

/// Boxes of the stacks whose height is not what is varied.
const BOXES: usize = 10;

impl Family {
    pub(crate) const ALL: [Self; 11] = [
        Self::Stacks,
        Self::MassRatios,
        Self::Chains,
        Self::TimeSteps,
        Self::Offsets,
        Self::SizesByDefault,
        Self::SizesTold,
        Self::Spins,
        Self::ShotsWithoutCcd,
        Self::ShotsWithCcd,
        Self::Extremes,
    ];

    /// Its name on the command line.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Stacks => "stacks",
            Self::MassRatios => "mass-ratios",
            Self::Chains => "chains",
            Self::TimeSteps => "time-steps",
            Self::Offsets => "offsets",
            Self::SizesByDefault => "sizes-by-default",
            Self::SizesTold => "sizes-told",
            Self::Spins => "spins",
            Self::ShotsWithoutCcd => "shots-without-ccd",
            Self::ShotsWithCcd => "shots-with-ccd",
            Self::Extremes => "extremes",
        }
    }

    /// What is built, in a few words.
    pub(crate) fn title(self) -> &'static str {
        match self {
            Self::Stacks => "stacks of boxes",
            Self::MassRatios => "a heavy box upon three light ones",
            Self::Chains => "chains of 100 links with a heavy end",
            Self::TimeSteps => "a stack of 10 by the time step",
            Self::Offsets => "a stack of 10 far from the origin",
            Self::SizesByDefault => "a stack of 10 in other units, length_unit at its default",
            Self::SizesTold => "a stack of 10 in other units, length_unit set to a metre",
            Self::Spins => "spinning boxes in a closed box",
            Self::ShotsWithoutCcd => "balls against a thin wall, without CCD",
            Self::ShotsWithCcd => "balls against a thin wall, with CCD",
            Self::Extremes => "flight and spin at the limits of the numbers",
        }
    }

    /// What its cases are told apart by, as the title of an axis.
    pub(crate) fn parameter(self) -> &'static str {
        match self {
            Self::Stacks => "boxes",
            Self::MassRatios => "mass ratio of neighbours",
            Self::Chains => "mass of the end, links",
            Self::TimeSteps => "time step, ms",
            Self::Offsets => "distance on each axis, boxes",
            Self::SizesByDefault | Self::SizesTold => "size of a box, units",
            Self::Spins => "spin, radians per second",
            Self::ShotsWithoutCcd | Self::ShotsWithCcd => "speed, metres per second",
            Self::Extremes => "speed, units per second",
        }
    }

    /// What its cases are judged by.
    pub(crate) fn criterion(self) -> Criterion {
        match self {
            Self::Chains => Criterion::HoldsTogether,
            Self::Spins | Self::ShotsWithoutCcd | Self::ShotsWithCcd => Criterion::StaysInside,
            Self::Extremes => Criterion::DoesNotPanic,
            _ => Criterion::StaysInPlace,
        }
    }

    /// Its cases, from harmless to hopeless.
    pub(crate) fn cases(self) -> Vec<Case> {
        let boxes = BOXES;
        let stack = |label: String, parameter| Case {
            family: self,
            label,
            parameter,
            setup: Setup::Stack { boxes },
            dt: DT,
            offset: 0.0,
            metre: 1.0,
            length_unit: 1.0,
            seconds: 5.0,
        };
        let made_of = |setup: Setup, label: String, parameter| Case {
            setup,
            ..stack(label, parameter)
        };
        let of = |parameters: &[f64], case: &dyn Fn(f64) -> Case| {
            parameters.iter().copied().map(case).collect()
        };
        const RATIOS: [f64; 5] = [1.0, 10.0, 100.0, 1_000.0, 10_000.0];
        match self {
            Self::Stacks => of(&[10.0, 20.0, 40.0], &|boxes| {
                let setup = Setup::Stack {
                    boxes: boxes as usize,
                };
                made_of(setup, format!("{boxes} boxes"), boxes)
            }),
            Self::MassRatios => of(&RATIOS, &|ratio| {
                made_of(Setup::Press { ratio }, format!("1 : {ratio}"), ratio)
            }),
            Self::Chains => of(&RATIOS, &|ratio| {
                let links = LINKS;
                let setup = Setup::Chain { links, ratio };
                made_of(setup, format!("1 : {ratio}"), ratio)
            }),
            Self::TimeSteps => of(&[120.0, 60.0, 30.0, 15.0], &|rate| Case {
                dt: rate.recip(),
                ..stack(format!("1/{rate} s"), 1e3 / rate)
            }),
            Self::Offsets => of(&[0.0, 1e3, 1e4, 1e5, 1e6], &|offset| Case {
                offset,
                ..stack(number(offset), offset)
            }),
            Self::SizesByDefault | Self::SizesTold => {
                of(&[1e-3, 1e-2, 1e-1, 1.0, 1e1, 1e2, 1e3], &|metre| Case {
                    metre,
                    length_unit: match self {
                        Self::SizesTold => metre,
                        _ => 1.0,
                    },
                    ..stack(number(metre), metre)
                })
            }
            Self::Spins => of(&[1.0, 10.0, 100.0, 1e3, 1e4], &|speed| {
                made_of(
                    Setup::Spin { speed },
                    format!("{} rad/s", number(speed)),
                    speed,
                )
            }),
            Self::ShotsWithoutCcd | Self::ShotsWithCcd => {
                of(&[10.0, 30.0, 100.0, 1e3, 1e4, 1e5], &|speed| {
                    let has_ccd = self == Self::ShotsWithCcd;
                    let setup = Setup::Shots { speed, has_ccd };
                    made_of(setup, format!("{} m/s", number(speed)), speed).lasting_at_most(1.0)
                })
            }
            Self::Extremes => of(
                &[1e6, 1e12, 1e18, 1e24, 1e30, 1e36, 1e38, f32::MAX.into()],
                &|speed| {
                    let setup = Setup::Burst { speed };
                    made_of(setup, number(speed), speed).lasting_at_most(1.0)
                },
            ),
        }
    }
}

/// A number in few characters.
fn number(number: f64) -> String {
    match number {
        0.0 => "0".to_owned(),
        _ if (1e-3..1e4).contains(&number) => format!("{number}"),
        _ if number == f64::from(f32::MAX) => "f32::MAX".to_owned(),
        _ => format!("{number:.0e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::Family;

    #[test]
    fn labels_tell_cases_apart() {
        for family in Family::ALL {
            let cases = family.cases();
            let labels: std::collections::HashSet<_> = cases.iter().map(|c| &c.label).collect();
            assert_eq!(labels.len(), cases.len(), "{}", family.name());
            assert!(cases.iter().all(|case| case.family == family));
            assert!(cases.windows(2).all(|c| c[0].parameter < c[1].parameter));
        }
    }

    #[test]
    fn time_steps_last_equally_long() {
        let steps = Family::TimeSteps.cases().into_iter().map(|c| c.steps());
        assert_eq!(steps.collect::<Vec<_>>(), [600, 300, 150, 75]);
    }
}
