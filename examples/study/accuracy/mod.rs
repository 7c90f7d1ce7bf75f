//! What the time buys: errors against the computing time for one simulated second.
//!
//! Scenes are simulated on Rapier's own broad phase, on unisize, and on methods that miss pairs in exchange for speed, with four time
//! steps, from starts that differ a little by their seed. Errors are measured by Rapier's world alone, so that they show what a broad
//! phase has lost: joints stretch, bodies are in each other or outside of what should hold them. What comes of it:
//!
//! - the **errors**, and the time of the processor for whole steps: medians over the seeds, with their intervals of 95 %;
//! - whether unisize can be **told apart** from Rapier's own broad phase by any error in any scene: a test on the same starts,
//!   corrected for the number of tests;
//! - whether the tests would **notice** a broad phase that loses one pair in a thousand, and the others that miss pairs.
//!
//! The solver goes through contacts in the order in which their pairs were reported, and in a calm scene another order can have a
//! tiny effect that is always the same. So the first start of every scene, and all starts of what is told apart, are simulated again
//! with the events of both in the same order: if they find the same pairs, the runs are then equal bit for bit, in all errors, and in
//! the motions of all bodies at the end.

pub(crate) mod case;
mod chart;
mod ensembles;
mod verdict;

use crate::finder::Finder;
use crate::options::Common;
use crate::output::{Output, number, table};
use crate::progress::progress_bar;
use crate::{FINDERS, dim2, dim3};
use anyhow::Result;
use case::{Case, Run};
use clap::Args;
use ensembles::Ensembles;
use indicatif::ProgressBar;
use serde::Serialize;
use std::ops::Range;
use unisize_scenes::SceneKind;
use verdict::{LEVEL, SHOWN, Verdict};

/// The scenes, which nothing moves but physics. Joints should hold, balls should rest beside each other, columns should stand, and
/// nothing should leave its container.
pub(crate) const SCENES: [SceneKind; 5] = [
    SceneKind::Ropes,
    SceneKind::FallingBalls,
    SceneKind::MixedEight,
    SceneKind::Stacks,
    SceneKind::Gas,
];

/// How many bodies there are, about, and how many seconds are simulated.
const BODIES: usize = 200;
const SECONDS: f64 = 2.0;

/// Steps per simulated second: the time steps of every curve.
const FREQUENCIES: [u32; 4] = [30, 60, 120, 240];

/// With fewer seeds nothing is said. With n seeds no p-value is less than 2 / 2<sup>n</sup>: with 11 seeds and some sixty tests, the
/// correction makes more than 0.05 of it. With a few more, only that all seeds agree would be seen.
const FEWEST_SEEDS: u64 = 15;

/// A quick run has so many bodies at most, and simulates this part of the time.
const QUICK_BODIES: usize = 40;
const QUICK_TIME: f64 = 0.4;

/// What does the time of a simulation buy, and can unisize be told apart from Rapier's own broad phase?
///
/// Exits with 1 if unisize is told apart by more than the order of events, if simulations differ though their events are in the same
/// order, or if the tests do not notice that one pair in a thousand is lost. Fewer than 15 seeds, and a quick run, give no verdict
/// but on the order.
#[derive(Args, Clone, Debug)]
pub(crate) struct Arguments {
    #[command(flatten)]
    common: Common,
    /// A scene; may be given several times [default: five of them]
    #[arg(long, value_name = "SCENE", value_parser = SCENES.map(SceneKind::name))]
    only: Vec<String>,
}

impl Arguments {
    /// Runs the study; whether unisize has passed.
    pub(crate) fn run(&self) -> Result<bool> {
        let mut output = Output::create("accuracy", &self.common)?;
        let seeds = self.common.seeds(2, 20);
        let scenes = self.common.scenes(&SCENES, &self.only);
        let runs = FINDERS.len() * FREQUENCIES.len() * (seeds.end - seeds.start) as usize;
        let bar = progress_bar((runs * scenes.len() * self.common.dims().len()) as u64);
        let mut studies = Vec::new();
        for &dim in self.common.dims() {
            for &scene in &scenes {
                bar.set_message(format!("{} {dim}D", scene.name()));
                let mut study = self.ensembles(dim, scene);
                measure(&mut study, seeds.clone(), &bar, &mut output)?;
                studies.push(study);
            }
        }
        bar.finish_and_clear();
        for &dim in self.common.dims() {
            output.chart(Some(dim), || chart::chart(dim, &studies))?;
        }
        self.conclude(&studies, seeds, &mut output)
    }

    fn ensembles(&self, dim: u8, kind: SceneKind) -> Ensembles {
        let bodies = self.common.usual(QUICK_BODIES, BODIES);
        let seconds = SECONDS * self.common.usual(QUICK_TIME, 1.0);
        // Steps are those of a sixtieth.
        let steps = self.common.steps.map(|steps| steps as f64 / 60.0);
        Ensembles::new(dim, kind, bodies, steps.unwrap_or(seconds).min(seconds))
    }

    fn conclude(
        &self,
        studies: &[Ensembles],
        seeds: Range<u64>,
        output: &mut Output,
    ) -> Result<bool> {
        let verdict = Verdict::of(studies);
        for comparison in &verdict.comparisons {
            output.row("comparison", comparison)?;
        }
        print_methods(studies, &verdict);
        print_short(studies, &verdict);
        let is_finite = studies.iter().all(Ensembles::is_finite);
        if !is_finite {
            println!("NOT FINITE: a simulation exploded.\n");
        }
        let has_verdict = !self.common.quick && seeds.end - seeds.start >= FEWEST_SEEDS;
        let mut is_equal = true;
        for study in studies {
            let is_told_apart = has_verdict && verdict.least(study, Finder::DEFAULT) < LEVEL;
            let seeds = match is_told_apart {
                true => seeds.clone(),
                false => seeds.start..seeds.start + 1,
            };
            let is_same = is_same_in_order(study, seeds);
            match (is_told_apart, is_same) {
                (_, false) => println!(
                    "{}: runs DIFFER even with the events in order.\n",
                    study.title()
                ),
                (true, true) => println!(
                    "{}: told apart by the order alone; with the events in order all runs are equal.\n",
                    study.title()
                ),
                _ => {}
            }
            is_equal &= is_same;
        }
        if is_equal {
            println!("With the events in order, unisize and Rapier's own are equal bit for bit.");
        }
        if !has_verdict {
            println!("No verdict: that takes {FEWEST_SEEDS} seeds, and no quick run.");
            return Ok(is_finite && is_equal);
        }
        let noticed = verdict.told_apart(studies, Finder::Lossy);
        println!(
            "unisize is told apart in {} of {} scenes by {} tests; the control in {noticed}.",
            verdict.told_apart(studies, Finder::DEFAULT),
            studies.len(),
            verdict.tests,
        );
        Ok(is_finite && is_equal && noticed > 0)
    }
}

/// Simulates a scene with every method, time step and seed. Methods go in turns, and another one begins with every seed, so that
/// none has the machine at a better time than the others.
fn measure(
    study: &mut Ensembles,
    seeds: Range<u64>,
    bar: &ProgressBar,
    output: &mut Output,
) -> Result<()> {
    let mut finders = FINDERS.to_vec();
    for seed in seeds {
        for frequency in FREQUENCIES {
            for &finder in &finders {
                let case = case(study, finder, frequency, seed);
                let run = simulate(study.dim, &case);
                output.row("run", &RunRow::of(study.dim, &case, &run))?;
                study.push(finder, frequency, run);
                bar.inc(1);
            }
        }
        finders.rotate_left(1);
    }
    Ok(())
}

fn case(study: &Ensembles, finder: Finder, frequency: u32, seed: u64) -> Case {
    Case {
        kind: study.kind,
        finder,
        is_sorted: false,
        frequency,
        seed,
        bodies: study.bodies,
        seconds: study.seconds,
    }
}

fn simulate(dim: u8, case: &Case) -> Run {
    match dim {
        2 => dim2::accuracy::run(case),
        _ => dim3::accuracy::run(case),
    }
}

/// Whether all runs of a scene are the same, bit for bit, with the events of each update sorted: all errors, and all bodies at the
/// end.
fn is_same_in_order(study: &Ensembles, seeds: Range<u64>) -> bool {
    let is_same = |seed: u64, frequency: u32| {
        let [own, ours] = [Finder::Rapier, Finder::DEFAULT].map(|finder| {
            let case = Case {
                is_sorted: true,
                ..case(study, finder, frequency, seed)
            };
            let run = simulate(study.dim, &case);
            (run.state, run.errors)
        });
        own == ours
    };
    let mut frequencies = FREQUENCIES.into_iter();
    frequencies.all(|frequency| seeds.clone().all(|seed| is_same(seed, frequency)))
}

/// Prints for each method what it does to the simulation, at 60 steps a second: the cost of whole steps, and each error.
fn print_methods(studies: &[Ensembles], verdict: &Verdict) {
    println!(
        "### What a method does to the simulation\n\nWhole steps over those of unisize, and the median of each error, both at 1/{SHOWN} s. \
         A star where it is told apart from Rapier's own.\n"
    );
    let mut head = vec!["scene".to_owned(), "what".to_owned()];
    head.extend(FINDERS.iter().map(|finder| match finder.is_exact() {
        true => finder.name(),
        false => format!("{} (can miss)", finder.name()),
    }));
    let mut table = table(head);
    let mut add = |scene: String, what: &str, cell: &dyn Fn(Finder) -> String| {
        let mut row = vec![scene, what.to_owned()];
        row.extend(FINDERS.iter().map(|&finder| cell(finder)));
        table.add_row(row);
    };
    let ratio = |study: &Ensembles, finder: Finder| {
        let ms = |finder| study.milliseconds(finder, SHOWN).value;
        ms(finder) / ms(Finder::DEFAULT)
    };
    add("all, geometric mean".to_owned(), "whole step", &|finder| {
        let logarithms = studies.iter().map(|study| ratio(study, finder).ln());
        number((logarithms.sum::<f64>() / studies.len() as f64).exp())
    });
    for study in studies {
        add(study.title(), "whole step", &|finder| {
            number(ratio(study, finder))
        });
        for (index, name) in study.errors().into_iter().enumerate() {
            add(study.title(), name, &|finder| {
                let mut of_scene = verdict.of_scene(study, finder);
                let is_apart = of_scene.any(|of| of.error == name && of.is_told_apart());
                let error = number(study.error(finder, SHOWN, index).value);
                format!("{error}{}", if is_apart { " *" } else { "" })
            });
        }
    }
    println!("{table}\n");
}

/// Prints the least p-value of each scene and method.
fn print_short(studies: &[Ensembles], verdict: &Verdict) {
    println!(
        "### Whether methods can be told apart from Rapier's own\n\nThe least corrected p of all errors of a scene; a star below {LEVEL}. \
         Pairs are those of all runs in which one in a thousand is lost.\n"
    );
    let others = || FINDERS.iter().filter(|&&finder| finder != Finder::Rapier);
    let mut head = vec!["scene".to_owned()];
    head.extend(others().map(|finder| finder.name()));
    head.extend(["pairs found", "lost"].map(str::to_owned));
    let mut table = table(head);
    for study in studies {
        let mut row = vec![study.title()];
        row.extend(others().map(|&finder| {
            let least = verdict.least(study, finder);
            format!("{}{}", number(least), if least < LEVEL { " *" } else { "" })
        }));
        row.extend(study.pairs(Finder::Lossy).map(|pairs| pairs.to_string()));
        table.add_row(row);
    }
    println!("{table}\n");
}

/// One simulation.
#[derive(Serialize)]
struct RunRow<'a> {
    dimension: u8,
    scene: &'a str,
    method: String,
    steps_per_second: u32,
    seed: u64,
    bodies: usize,
    seconds: f64,
    #[serde(flatten)]
    run: &'a Run,
}

impl<'a> RunRow<'a> {
    fn of(dimension: u8, case: &Case, run: &'a Run) -> Self {
        Self {
            dimension,
            scene: case.kind.name(),
            method: case.finder.name(),
            steps_per_second: case.frequency,
            seed: case.seed,
            bodies: case.bodies,
            seconds: case.seconds,
            run,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Ensembles, FINDERS, FREQUENCIES, Output, SceneKind, measure};
    use crate::options::Common;
    use clap::{Args, Command, FromArgMatches};
    use indicatif::ProgressBar;

    #[test]
    fn rows_are_lines_of_json() {
        let file = std::env::temp_dir().join(format!("unisize-study-{}.json", std::process::id()));
        let command = Common::augment_args(Command::new("study"));
        let line = ["study", "--json", file.to_str().unwrap()];
        let common = Common::from_arg_matches(&command.get_matches_from(line)).unwrap();
        let mut output = Output::create("accuracy", &common).unwrap();
        let mut study = Ensembles::new(2, SceneKind::Stacks, 10, 0.1);
        measure(&mut study, 1..3, &ProgressBar::hidden(), &mut output).unwrap();
        drop(output);
        let text = std::fs::read_to_string(&file).unwrap();
        std::fs::remove_file(&file).unwrap();
        let rows = text
            .lines()
            .map(|line| serde_json::from_str::<serde_json::Value>(line).unwrap());
        let rows: Vec<_> = rows.collect();
        assert_eq!(rows.len(), 2 * FINDERS.len() * FREQUENCIES.len());
        assert_eq!(
            (rows[0]["study"].as_str(), rows[0]["seed"].as_u64()),
            (Some("accuracy"), Some(1))
        );
        assert!(
            rows.iter()
                .all(|row| row["milliseconds"].as_f64().unwrap() > 0.0)
        );
        assert!(rows.iter().all(|row| row["errors"][0]["name"].is_string()));
    }
}
