//! Does a world fall asleep sooner or later than on Rapier's own broad phase?
//!
//! A world that sleeps costs next to nothing, so the time until then decides what a pile costs. The order of events decides the last bits
//! of the solver's result, and a pile is chaotic. So both broad phases get many starts, and what is compared are distributions: the
//! median, the quartiles, and a rank-sum test of whether the two differ.

use crate::options::Common;
use crate::output::Output;
use crate::statistics::{holm, rank_sum_test};
use crate::{dim2, dim3};
use anyhow::Result;
use rayon::ThreadPoolBuilder;
use serde_json::Value;
use unisize_scenes::{SceneKind, Spread};

/// The scenes that come to rest by themselves.
const SCENES: [SceneKind; 8] = [
    SceneKind::FallingBalls,
    SceneKind::MixedOneAndAHalf,
    SceneKind::Pyramid,
    SceneKind::Columns,
    SceneKind::Stacks,
    SceneKind::Wall,
    SceneKind::SettledPile,
    SceneKind::SettledHeap,
];

/// The number of bodies, of starts and of steps at most, in a quick run and in a full one.
const BODIES: [usize; 2] = [30, 400];
const STARTS: [usize; 2] = [3, 50];
const STEPS: [usize; 2] = [600, 3_600];

/// Steps per simulated second.
const FREQUENCY: f64 = 60.0;

/// Two distributions differ if the p-value, corrected for the number of scenes, is less than this.
const LEVEL: f64 = 0.05;

/// A scene to step until it is asleep.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Case {
    pub(crate) kind: SceneKind,
    /// About how many bodies.
    pub(crate) bodies: usize,
    /// The number of steps at most.
    pub(crate) steps: usize,
}

/// All starts of a case in one dimension.
struct Outcome {
    dim: u8,
    case: Case,
    /// The simulated seconds until all bodies sleep, on Rapier's own broad phase and on unisize.
    seconds: [Vec<f64>; 2],
    /// How many of the worlds are awake at the end.
    awake: [usize; 2],
}

/// Runs the study, on all processors, since it measures no computing time; whether any world has fallen asleep.
pub(crate) fn run(common: &Common) -> Result<bool> {
    let mut output = Output::create(common)?;
    let pool = ThreadPoolBuilder::new().build()?;
    let outcomes = common.each(
        &SCENES,
        |kind| kind.name(),
        |dim, &kind| pool.install(|| outcome(common, dim, kind)),
    );
    for outcome in &outcomes {
        outcome.report(&mut output)?;
    }
    let p_values: Vec<_> = outcomes.iter().map(Outcome::p).collect();
    let corrected = holm(&p_values, 0);
    let differing = corrected.iter().filter(|&&p| p < LEVEL).count();
    println!(
        "\nThe times until sleep differ significantly in {differing} of {} scenes.",
        outcomes.len()
    );
    Ok(outcomes.iter().any(Outcome::has_slept))
}

fn outcome(common: &Common, dim: u8, kind: SceneKind) -> Outcome {
    let case = Case {
        kind,
        bodies: common.usual(BODIES),
        steps: common.steps.unwrap_or(common.usual(STEPS)),
    };
    let starts = common.seeds(STARTS);
    let steps = match dim {
        2 => dim2::asleep::steps_until_asleep(&case, starts),
        _ => dim3::asleep::steps_until_asleep(&case, starts),
    };
    let seconds = |side: usize| {
        let steps = steps.iter().map(|of| of[side].unwrap_or(case.steps));
        steps.map(|steps| steps as f64 / FREQUENCY).collect()
    };
    let awake = |side: usize| steps.iter().filter(|of| of[side].is_none()).count();
    Outcome {
        dim,
        case,
        seconds: [0, 1].map(seconds),
        awake: [0, 1].map(awake),
    }
}

impl Outcome {
    fn p(&self) -> f64 {
        let [rapier, unisize] = &self.seconds;
        rank_sum_test(rapier, unisize)
    }

    fn has_slept(&self) -> bool {
        let starts = self.seconds[0].len();
        self.awake.iter().any(|&awake| awake < starts)
    }

    fn report(&self, output: &mut Output) -> Result<()> {
        let starts = self.seconds[0].len();
        let mut row: Vec<(&str, Value)> = vec![
            ("dimension", self.dim.into()),
            ("scene", self.case.kind.name().into()),
            ("bodies", self.case.bodies.into()),
            ("starts", starts.into()),
        ];
        let names = [
            ["rapier_lower", "rapier_median", "rapier_upper"],
            ["unisize_lower", "unisize_median", "unisize_upper"],
        ];
        for (seconds, names) in self.seconds.iter().zip(names) {
            let spread = Spread::of(seconds.iter().copied());
            let figures = spread.map_or([f64::NAN; 3], |of| [of.lower, of.median, of.upper]);
            row.extend(names.into_iter().zip(figures.map(Value::from)));
        }
        row.extend([
            ("rapier_awake", self.awake[0].into()),
            ("unisize_awake", self.awake[1].into()),
            ("p", self.p().into()),
        ]);
        output.row("asleep", &row)
    }
}
