//! The families of cases: in each, one parameter goes from harmless to hopeless.

use super::case::{Case, Setup};

/// Cases that differ in one parameter.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Family {
    /// A short name.
    pub(crate) name: &'static str,
    /// What is built, in a few words.
    pub(crate) title: &'static str,
    /// What its cases are told apart by, with its unit.
    pub(crate) parameter: &'static str,
    /// From harmless to hopeless.
    pub(crate) range: [f64; 2],
    build: fn(f64) -> Case,
}

/// A parameter that is a whole number.
const COUNT: &str = "boxes";

/// The stack whose height is not what is varied.
const STACK: Case = Case::usual(Setup::Stack(10));

impl Family {
    pub(crate) const ALL: [Self; 13] = [
        Self {
            name: "stacks",
            title: "stacks of boxes",
            parameter: COUNT,
            range: [5.0, 80.0],
            build: |boxes| Case::usual(Setup::Stack(boxes as usize)),
        },
        Self {
            name: "mass-ratios",
            title: "a heavy box upon three light ones",
            parameter: "mass ratio of neighbours",
            range: [1.0, 1e4],
            build: |ratio| Case::usual(Setup::Press { ratio }),
        },
        Self {
            name: "chains",
            title: "chains of 100 links with a heavy end",
            parameter: "mass of the end, links",
            range: [1.0, 1e4],
            build: |ratio| Case::usual(Setup::Chain { ratio }),
        },
        Self {
            name: "time-steps",
            title: "a stack of 10 by the time step",
            parameter: "time step, ms",
            range: [4.0, 200.0],
            build: |ms| Case {
                dt: ms / 1e3,
                ..STACK
            },
        },
        Self {
            name: "offsets",
            title: "a stack of 10 far from the origin",
            parameter: "distance on each axis, boxes",
            range: [1e2, 1e8],
            build: |offset| Case { offset, ..STACK },
        },
        Self {
            name: "small-by-default",
            title: "a stack of 10 small boxes, length_unit at its default",
            parameter: "boxes in a unit",
            range: [1.0, 1e3],
            build: |shrink| in_units(1.0 / shrink, 1.0),
        },
        Self {
            name: "small-told",
            title: "a stack of 10 small boxes, length_unit set to a metre",
            parameter: "boxes in a unit",
            range: [1.0, 1e3],
            build: |shrink| in_units(1.0 / shrink, 1.0 / shrink),
        },
        Self {
            name: "large-by-default",
            title: "a stack of 10 large boxes, length_unit at its default",
            parameter: "units in a box",
            range: [1.0, 1e3],
            build: |metre| in_units(metre, 1.0),
        },
        Self {
            name: "large-told",
            title: "a stack of 10 large boxes, length_unit set to a metre",
            parameter: "units in a box",
            range: [1.0, 1e3],
            build: |metre| in_units(metre, metre),
        },
        Self {
            name: "spins",
            title: "spinning boxes in a closed box",
            parameter: "spin, radians per second",
            range: [1.0, 1e4],
            build: |speed| Case::usual(Setup::Spin { speed }),
        },
        Self {
            name: "shots-without-ccd",
            title: "balls against a thin wall, without CCD",
            parameter: "speed, metres per second",
            range: [1.0, 1e5],
            build: |speed| shots(speed, false),
        },
        Self {
            name: "shots-with-ccd",
            title: "balls against a thin wall, with CCD",
            parameter: "speed, metres per second",
            range: [1.0, 1e5],
            build: |speed| shots(speed, true),
        },
        Self {
            name: "extremes",
            title: "flight and spin at the limits of the numbers",
            parameter: "speed, units per second",
            range: [1e6, f32::MAX as f64],
            build: |speed| Case::usual(Setup::Burst { speed }).lasting_at_most(1.0),
        },
    ];

    /// The case with this parameter.
    pub(crate) fn case(&self, value: f64) -> Case {
        (self.build)(value)
    }

    /// So many values of the parameter, evenly spread over the logarithms of its range; those of what is counted are whole.
    pub(crate) fn values(&self, count: usize) -> Vec<f64> {
        let [low, high] = self.range;
        let mut values: Vec<_> = (0..count)
            .map(|index| match index + 1 == count {
                true => high,
                false => low * (high / low).powf(index as f64 / (count - 1) as f64),
            })
            .collect();
        if self.parameter == COUNT {
            values.iter_mut().for_each(|value| *value = value.round());
            values.dedup();
        }
        values
    }

    /// The family of this name, for tests.
    #[cfg(test)]
    pub(crate) fn named(name: &str) -> &'static Self {
        const ALL: &[Family] = &Family::ALL;
        ALL.iter().find(|family| family.name == name).unwrap()
    }
}

/// A stack with so many units in a metre, and a length unit of so many.
fn in_units(metre: f64, length_unit: f64) -> Case {
    Case {
        metre,
        length_unit,
        ..STACK
    }
}

fn shots(speed: f64, has_ccd: bool) -> Case {
    Case::usual(Setup::Shots { speed, has_ccd }).lasting_at_most(1.0)
}

#[cfg(test)]
mod tests {
    use super::Family;

    #[test]
    fn values_go_up_and_make_different_cases() {
        for family in &Family::ALL {
            let values = family.values(33);
            assert_eq!([values[0], *values.last().unwrap()], family.range);
            assert!(values.windows(2).all(|pair| pair[0] < pair[1]));
            let cases: Vec<_> = values.iter().map(|&value| family.case(value)).collect();
            let differ = cases.windows(2).all(|pair| pair[0] != pair[1]);
            assert!(differ, "{}", family.name);
        }
    }

    #[test]
    fn time_steps_last_equally_long() {
        let family = Family::named("time-steps");
        let steps = [10.0, 20.0, 50.0].map(|ms| family.case(ms).steps());
        assert_eq!(steps, [500, 250, 100]);
    }
}
