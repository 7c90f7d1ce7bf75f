//! What it costs to move a whole world at once, one type for both dimensions.

use std::collections::BTreeSet;
use std::ops::RangeInclusive;
use unisize_scenes::SceneKind;

/// What is shifted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Scenery {
    pub(crate) kind: SceneKind,
    /// Whether bodies move, or have been given no velocity.
    pub(crate) is_moving: bool,
}

impl Scenery {
    /// What is measured.
    pub(crate) const ALL: [Self; 4] = [
        Self::of(SceneKind::Gas, false),
        Self::of(SceneKind::Gas, true),
        Self::of(SceneKind::Crowd, false),
        Self::of(SceneKind::Crowd, true),
    ];

    const fn of(kind: SceneKind, is_moving: bool) -> Self {
        Self { kind, is_moving }
    }

    /// Its name in a table.
    pub(crate) fn name(self) -> String {
        let state = if self.is_moving { "moving" } else { "at rest" };
        format!("{}, {state}", self.kind.name())
    }
}

/// The steps of a world that was shifted now and then.
#[derive(Clone, Debug)]
pub(crate) struct Shift {
    pub(crate) scenery: Scenery,
    pub(crate) bodies: usize,
    pub(crate) steps: Vec<Step>,
    /// What touches after the first shift.
    pub(crate) kept: Kept,
    /// The first difference in the pairs that both broad phases hold.
    pub(crate) difference: Option<String>,
}

/// What the broad phases did in one step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Step {
    /// Whether all was shifted before it.
    pub(crate) is_shift: bool,
    /// How long Rapier's own broad phase took, in milliseconds: first the update that hears of shifts, then the rest.
    pub(crate) default: [f64; 2],
    /// How long unisize took.
    pub(crate) ours: [f64; 2],
    /// The full runs of unisize.
    pub(crate) full_runs: u64,
    /// The pairs that unisize watches after the step.
    pub(crate) candidates: usize,
}

/// The pairs that touch after a shift, beside those of a twin that was not shifted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Kept {
    /// Pairs that touch in both.
    pub(crate) both: usize,
    /// Pairs that touch in the shifted world alone, by more than rounding.
    pub(crate) new: usize,
    /// Pairs that touch in the twin alone, by more than rounding.
    pub(crate) lost: usize,
}

impl Kept {
    /// From the pairs that overlap by a depth or more, which may be negative.
    pub(crate) fn of<T: Ord>(
        shifted: impl Fn(f64) -> BTreeSet<T>,
        twin: impl Fn(f64) -> BTreeSet<T>,
        rounding: f64,
    ) -> Self {
        Self {
            both: shifted(0.0).intersection(&twin(0.0)).count(),
            new: shifted(rounding).difference(&twin(-rounding)).count(),
            lost: twin(rounding).difference(&shifted(-rounding)).count(),
        }
    }

    /// Whether anything touches: if not, there was no contact that the shift could have changed.
    pub(crate) fn touches(&self) -> bool {
        self.both + self.new + self.lost > 0
    }
}

/// Steps after a shift that are told apart from ordinary ones.
const AFTERMATH: usize = 5;

/// At the start, lists grow, and the first fat boxes are drawn.
const START: usize = 10;

impl Shift {
    /// The steps before which all was shifted.
    pub(crate) fn shifts(&self) -> Vec<Step> {
        let steps = self.steps.iter().copied();
        steps.filter(|step| step.is_shift).collect()
    }

    /// The steps after each shift, all together.
    pub(crate) fn aftermath(&self) -> Vec<Step> {
        self.steps_by_age(1..=AFTERMATH)
    }

    /// All other steps but the first ones.
    pub(crate) fn ordinary(&self) -> Vec<Step> {
        self.steps_by_age(AFTERMATH + 1..=usize::MAX)
    }

    /// Those of them in which unisize searched for all pairs.
    pub(crate) fn with_full_run(&self) -> Vec<Step> {
        let mut steps = self.ordinary();
        steps.retain(|step| step.full_runs > 0);
        steps
    }

    /// Whether both broad phases hold the same pairs, and a shift of what is at rest changes no contact by more than rounding.
    ///
    /// What moves goes on for a step before its contacts are looked at: two balls that touch by a last bit bounce in one world and
    /// not in the other. Where nothing [touches](Kept::touches), the pairs alone decide.
    pub(crate) fn is_sound(&self) -> bool {
        let is_kept = self.kept.new + self.kept.lost == 0;
        self.difference.is_none() && (self.scenery.is_moving || is_kept)
    }

    /// The steps by how many steps before them the last shift was.
    fn steps_by_age(&self, ages: RangeInclusive<usize>) -> Vec<Step> {
        let mut age = AFTERMATH;
        let mut found = Vec::new();
        for step in self.steps.iter().skip(START) {
            age = if step.is_shift { 0 } else { age + 1 };
            if ages.contains(&age) {
                found.push(*step);
            }
        }
        found
    }
}

/// The median of a figure; NaN of nothing.
pub(crate) fn median(steps: &[Step], figure: impl Fn(&Step) -> f64) -> f64 {
    let mut figures: Vec<_> = steps.iter().map(figure).collect();
    figures.sort_by(f64::total_cmp);
    figures.get(figures.len() / 2).copied().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::{Kept, Scenery, Shift, Step, median};
    use std::collections::BTreeSet;

    #[test]
    fn steps_are_told_apart_by_the_last_shift() {
        let steps = (0..40).map(|index| Step {
            is_shift: index == 20,
            ours: [f64::from(index), 0.0],
            full_runs: u64::from(index == 30),
            ..Step::default()
        });
        let shift = Shift {
            scenery: Scenery::ALL[0],
            bodies: 0,
            steps: steps.collect(),
            kept: Kept::default(),
            difference: None,
        };
        let numbers = |steps: Vec<Step>| steps.iter().map(|s| s.ours[0] as i32).collect::<Vec<_>>();
        assert_eq!(numbers(shift.shifts()), [20]);
        assert_eq!(numbers(shift.aftermath()), [21, 22, 23, 24, 25]);
        let ordinary: Vec<_> = (10..20).chain(26..40).collect();
        assert_eq!(numbers(shift.ordinary()), ordinary);
        assert_eq!(median(&shift.aftermath(), |step| step.ours[0]), 23.0);
        assert_eq!(numbers(shift.with_full_run()), [30]);
    }

    #[test]
    fn rounding_neither_gives_nor_takes_a_pair() {
        let world = |depths: [f64; 3]| {
            move |depth: f64| {
                let touching = (0..3).filter(|&pair| depths[pair] >= depth);
                touching.collect::<BTreeSet<_>>()
            }
        };
        let kept = |shifted, twin| {
            let Kept { both, new, lost } = Kept::of(world(shifted), world(twin), 0.1);
            [both, new, lost]
        };
        assert_eq!(kept([1.0, 0.0, -1.0], [1.0, 0.0, -1.0]), [2, 0, 0]);
        assert!(!Kept::of(world([-1.0; 3]), world([-1.0; 3]), 0.1).touches());
        // One touches here and not there, but hardly.
        assert_eq!(kept([1.0, 0.05, -1.0], [1.0, -0.05, -1.0]), [1, 0, 0]);
        assert_eq!(kept([1.0, 0.5, -1.0], [1.0, -0.5, -1.0]), [1, 1, 0]);
        assert_eq!(kept([-1.0, 0.0, -1.0], [1.0, 0.0, -1.0]), [1, 0, 1]);
    }
}
