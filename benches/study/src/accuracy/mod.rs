//! Errors against the computing time for one simulated second.
//!
//! The study simulates scenes on Rapier's own broad phase, on unisize, and on methods that miss pairs in exchange for speed, with four
//! time steps, from starts that differ a little by their seed. It reads errors from Rapier's world alone, so that they show the pairs
//! that a broad phase has lost: joints stretch, bodies overlap or leave their container. The results:
//!
//! - for each **method**, the time of whole steps and its errors in the scene where they are largest;
//! - whether any error in any scene **differs significantly** from that of Rapier's own broad phase: a test on the same starts,
//!   corrected for the number of tests;
//! - whether the tests **notice** a broad phase that loses one pair in a thousand.
//!
//! The solver goes through contacts in the order in which their pairs were reported. In a calm scene another order can have a tiny
//! effect that is always the same. So the first start of every scene, and all starts of a scene in which unisize differs, are simulated
//! again with the events of both in the same order. If both find the same pairs, the runs are then equal bit for bit, in all errors and
//! in the motions of all bodies at the end.

pub(crate) mod ensembles;
mod verdict;

use crate::finder::{FINDERS, Finder};
use crate::options::Common;
use crate::output::Output;
use crate::statistics::geometric_mean;
use crate::{dim2, dim3};
use anyhow::Result;
use ensembles::{DEEPEST, Ensembles, LOST, STRAYED, STRETCH};
use std::ops::Range;
use unisize_scenes::SceneKind;
use verdict::Verdict;

/// The scenes, which only physics moves. Joints should hold, balls should rest next to each other, columns should stand, and no body
/// should leave its container.
pub(crate) const SCENES: [SceneKind; 5] = [
    SceneKind::Ropes,
    SceneKind::FallingBalls,
    SceneKind::MixedEight,
    SceneKind::Columns,
    SceneKind::Gas,
];

/// The approximate number of bodies, and the simulated seconds, in a quick run and in a full one.
const BODIES: [usize; 2] = [40, 200];
const SECONDS: [f64; 2] = [0.8, 2.0];

/// Steps per simulated second: the time steps of every curve.
const FREQUENCIES: [u32; 4] = [30, 60, 120, 240];

/// The time step of the tables, in steps per second.
const SHOWN: u32 = 60;

/// With fewer seeds there is no verdict. With n seeds no p-value is less than 2 / 2<sup>n</sup>. With 11 seeds and some sixty tests, the
/// correction raises it above 0.05; with a few more seeds, the tests see a difference only if all seeds agree.
const FEWEST_SEEDS: u64 = 15;

/// Runs the study; whether unisize has passed.
pub(crate) fn run(common: &Common) -> Result<bool> {
    let mut output = Output::create(common)?;
    let seeds = common.seeds([2, 20]);
    let seconds = common.usual(SECONDS);
    // Steps are those of a sixtieth.
    let steps = common.steps.map(|steps| steps as f64 / 60.0);
    let seconds = steps.unwrap_or(seconds).min(seconds);
    let bodies = common.usual(BODIES);
    let studies = common.each(
        &SCENES,
        |kind| kind.name(),
        |dim, &kind| {
            let mut study = Ensembles::new(dim, kind, bodies, seconds);
            measure(&mut study, seeds.clone());
            study
        },
    );
    let verdict = Verdict::of(&studies);
    report(&studies, &verdict, &mut output)?;
    Ok(conclude(common, &studies, &verdict, seeds))
}

fn conclude(common: &Common, studies: &[Ensembles], verdict: &Verdict, seeds: Range<u64>) -> bool {
    let is_finite = studies.iter().all(Ensembles::is_finite);
    if !is_finite {
        println!("\nNOT FINITE: a simulation exploded.");
    }
    let has_verdict = !common.quick && seeds.end - seeds.start >= FEWEST_SEEDS;
    let mut is_equal = true;
    for (scene, study) in studies.iter().enumerate() {
        let is_told_apart = has_verdict && verdict.tells_apart(scene, Finder::DEFAULT);
        let count = if is_told_apart {
            seeds.end - seeds.start
        } else {
            1
        };
        let is_same = is_same_in_order(study, seeds.start..seeds.start + count);
        let title = study.title();
        if !is_same {
            println!("\n{title}: runs DIFFER, even with events in order.");
        } else if is_told_apart {
            println!("\n{title}: told apart by the order of events alone.");
        }
        is_equal &= is_same;
    }
    if is_equal {
        println!("\nWith events in order, unisize and Rapier's own are equal bit for bit.");
    }
    if !has_verdict {
        println!("No verdict: that takes {FEWEST_SEEDS} seeds, and no quick run.");
        return is_finite && is_equal;
    }
    let told_apart = |finder| verdict.told_apart(studies.len(), finder);
    let noticed = told_apart(Finder::Lossy);
    println!(
        "unisize is told apart in {} of {} scenes by {} tests; the control in {noticed}.",
        told_apart(Finder::DEFAULT),
        studies.len(),
        verdict.tests(Finder::DEFAULT),
    );
    is_finite && is_equal && noticed > 0
}

/// Simulates a scene with every method, time step and seed. Methods take turns, and another one begins with every seed, so that no
/// method has the machine at a better time than the others.
fn measure(study: &mut Ensembles, seeds: Range<u64>) {
    let mut finders = FINDERS.to_vec();
    for seed in seeds {
        for frequency in FREQUENCIES {
            for &finder in &finders {
                let case = study.case(finder, frequency, seed);
                let run = match study.dim {
                    2 => dim2::accuracy::run(&case),
                    _ => dim3::accuracy::run(&case),
                };
                study.push(finder, frequency, run);
            }
        }
        finders.rotate_left(1);
    }
}

/// Whether all runs of a scene are the same, bit for bit, with the events of each update in order.
fn is_same_in_order(study: &Ensembles, mut seeds: Range<u64>) -> bool {
    seeds.all(|seed| {
        FREQUENCIES.into_iter().all(|frequency| {
            let case = study.case(Finder::DEFAULT, frequency, seed);
            match study.dim {
                2 => dim2::accuracy::is_same_in_order(&case),
                _ => dim3::accuracy::is_same_in_order(&case),
            }
        })
    })
}

/// Writes a row for each method in all scenes, and for each error in each scene.
fn report(studies: &[Ensembles], verdict: &Verdict, output: &mut Output) -> Result<()> {
    for &finder in FINDERS {
        let step = |study: &Ensembles| {
            study.milliseconds(finder, SHOWN) / study.milliseconds(Finder::DEFAULT, SHOWN)
        };
        let steps: Vec<_> = studies.iter().map(step).collect();
        let worst = |name: &str| {
            let of_scene = |study: &Ensembles| {
                let index = study.errors().iter().position(|error| *error == name)?;
                Some(study.error(finder, SHOWN, index))
            };
            studies.iter().filter_map(of_scene).reduce(f64::max)
        };
        let scenes = studies.len();
        let told_apart = (finder != Finder::Rapier)
            .then(|| format!("{} of {scenes}", verdict.told_apart(scenes, finder)));
        output.row(
            "method",
            &[
                ("method", finder.name().into()),
                ("cannot_miss", finder.is_exact().into()),
                ("step", geometric_mean(&steps).into()),
                ("stretch", worst(STRETCH).into()),
                ("strayed", worst(STRAYED).into()),
                ("penetration", worst(DEEPEST).into()),
                ("lost_percent", worst(LOST).map(|lost| 100.0 * lost).into()),
                ("told_apart", told_apart.into()),
            ],
        )?;
    }
    for study in studies {
        report_curves(study, output)?;
    }
    for comparison in &verdict.0 {
        let study = &studies[comparison.scene];
        let median = |finder| study.error(finder, SHOWN, comparison.error).into();
        output.row(
            "error",
            &[
                ("dimension", study.dim.into()),
                ("scene", study.case.kind.name().into()),
                ("error", study.errors()[comparison.error].into()),
                ("method", comparison.finder.name().into()),
                ("rapier", median(Finder::Rapier)),
                ("other", median(comparison.finder)),
                ("worse", comparison.worse.into()),
                ("better", comparison.better.into()),
                ("p", comparison.p.into()),
                ("corrected", comparison.corrected.into()),
            ],
        )?;
    }
    Ok(())
}

/// Writes a row for each method and time step of a scene, from which the chart of errors against computing time is drawn.
fn report_curves(study: &Ensembles, output: &mut Output) -> Result<()> {
    let errors = study.errors();
    let frequencies = |&finder: &Finder| FREQUENCIES.map(|frequency| (finder, frequency));
    for (finder, frequency) in FINDERS.iter().flat_map(frequencies) {
        let error = |name: &str| {
            let index = errors.iter().position(|error| *error == name);
            index.map(|index| study.error(finder, frequency, index))
        };
        output.row(
            "curve",
            &[
                ("dimension", study.dim.into()),
                ("scene", study.case.kind.name().into()),
                ("bodies", study.case.bodies.into()),
                ("method", finder.name().into()),
                ("cannot_miss", finder.is_exact().into()),
                ("steps_a_second", frequency.into()),
                ("ms", study.milliseconds(finder, frequency).into()),
                ("stretch", error(STRETCH).into()),
                ("strayed", error(STRAYED).into()),
                ("penetration", error(DEEPEST).into()),
            ],
        )?;
    }
    Ok(())
}
