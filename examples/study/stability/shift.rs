//! What it costs to move a whole world at once, one type for both dimensions.

use crate::output::number;
use serde::Serialize;
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
    /// How long Rapier's own broad phase took in all of the step, and unisize, in milliseconds.
    pub(crate) ms: [f64; 2],
    /// The full runs of unisize.
    pub(crate) full_runs: u64,
}

/// The pairs that touch after a shift, beside those of a twin that was not shifted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
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
}

/// Steps after a shift that are told apart from ordinary ones.
const AFTERMATH: usize = 5;

/// At the start, lists grow, and the first fat boxes are drawn.
const START: usize = 10;

/// A kind of steps: how long the broad phases took, as medians, and how often unisize searched for all pairs, as a mean.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct Cost {
    pub(crate) rapier_ms: f64,
    pub(crate) unisize_ms: f64,
    pub(crate) full_runs: f64,
}

impl Shift {
    /// The cost of ordinary steps, of those of a shift, and of those right after one.
    pub(crate) fn costs(&self) -> [Cost; 3] {
        [AFTERMATH + 1..=usize::MAX, 0..=0, 1..=AFTERMATH].map(|ages| {
            let steps = self.steps_by_age(ages);
            let median = |side: usize| {
                let mut ms: Vec<_> = steps.iter().map(|step| step.ms[side]).collect();
                ms.sort_by(f64::total_cmp);
                ms.get(ms.len() / 2).copied().unwrap_or(f64::NAN)
            };
            let full_runs: u64 = steps.iter().map(|step| step.full_runs).sum();
            Cost {
                rapier_ms: median(0),
                unisize_ms: median(1),
                full_runs: full_runs as f64 / steps.len() as f64,
            }
        })
    }

    /// A row of a table with these headings.
    pub(crate) fn cells(&self, dim: u8) -> Vec<String> {
        let mut cells = vec![format!("{} {dim}D", self.scenery.name())];
        for cost in self.costs() {
            cells.extend([cost.rapier_ms, cost.unisize_ms, cost.full_runs].map(number));
        }
        cells.push(match &self.difference {
            None => "equal".to_owned(),
            Some(_) => "DIFFER".to_owned(),
        });
        let Kept { both, new, lost } = self.kept;
        cells.push(format!("{both} / {new} / {lost}"));
        cells
    }

    /// Whether both broad phases hold the same pairs, and a shift of what is at rest changes no contact by more than rounding.
    ///
    /// What moves goes on for a step before its contacts are looked at: two balls that touch by a last bit bounce in one world and
    /// not in the other. Where nothing touches, the pairs alone decide.
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

/// The headings of a table of shifts.
pub(crate) const HEAD: [&str; 12] = [
    "scene",
    "ordinary step, ms: Rapier's",
    "unisize",
    "full runs",
    "step of a shift, ms: Rapier's",
    "unisize",
    "full runs",
    "each of five after, ms: Rapier's",
    "unisize",
    "full runs",
    "pairs",
    "touching: kept / new / lost",
];

#[cfg(test)]
mod tests {
    use super::{Kept, Scenery, Shift, Step};
    use std::collections::BTreeSet;

    #[test]
    fn steps_are_told_apart_by_the_last_shift() {
        let steps = (0..40).map(|index| Step {
            is_shift: index == 20,
            ms: [0.0, f64::from(index)],
            full_runs: u64::from(index == 30),
        });
        let shift = Shift {
            scenery: Scenery::ALL[0],
            bodies: 0,
            steps: steps.collect(),
            kept: Kept::default(),
            difference: None,
        };
        let [ordinary, shifted, after] = shift.costs();
        assert_eq!([shifted.unisize_ms, after.unisize_ms], [20.0, 23.0]);
        assert_eq!([shifted.full_runs, after.full_runs], [0.0, 0.0]);
        // Ten before, and fourteen after the aftermath.
        assert_eq!(ordinary.full_runs, 1.0 / 24.0);
        assert_eq!(ordinary.unisize_ms, 28.0);
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
        assert_eq!(kept([-1.0; 3], [-1.0; 3]), [0; 3]);
        // One touches here and not there, but hardly.
        assert_eq!(kept([1.0, 0.05, -1.0], [1.0, -0.05, -1.0]), [1, 0, 0]);
        assert_eq!(kept([1.0, 0.5, -1.0], [1.0, -0.5, -1.0]), [1, 1, 0]);
        assert_eq!(kept([-1.0, 0.0, -1.0], [1.0, 0.0, -1.0]), [1, 0, 1]);
    }
}
