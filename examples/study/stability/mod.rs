//! Where small worlds fail, does unisize fail alone?
//!
//! Small worlds are taken to their limits: high stacks, heavy things on light ones, chains with a heavy end, long time steps, places
//! far from the origin, tiny and huge sizes, fast spin and flight. For each family of worlds a bisection finds the *threshold*: the
//! largest value of its parameter at which no start fails. A value is tried from several starts on Rapier's own broad phase and on
//! unisize, alone, and judged by a computed [`criterion`](criterion). Whether unisize
//! [fails more often](discordance) is told for each value, and for all of them together. Three more checks leave nothing to chance:
//!
//! - unisize must not panic from a start from which Rapier's own does not;
//! - with the events of each update in order, both worlds must end alike to the bit;
//! - in one world, both must hold the same pairs after each step.

pub(crate) mod case;
pub(crate) mod caught;
pub(crate) mod criterion;
mod discordance;
pub(crate) mod end;
pub(crate) mod family;
pub(crate) mod probe;
mod threshold;

use crate::options::{Common, at_least_one};
use crate::output::{Output, number, percent, table};
use crate::progress::progress_bar;
use crate::statistics::rarer_than;
use crate::{dim2, dim3};
use anyhow::Result;
use case::Case;
use clap::Args;
use comfy_table::Table;
use discordance::Discordance;
use family::Family;
use probe::{Exact, Probe, Seeds};
use rayon::ThreadPoolBuilder;
use serde::Serialize;
use std::collections::BTreeMap;
use threshold::last_sound;

/// How many values there are between the ends of a family's range, of a full run and of a quick one.
const VALUES: usize = 65;
const QUICK_VALUES: usize = 5;

/// Where small worlds fail, does unisize fail alone?
///
/// Exits with 1 if unisize fails alone at any value, or more often at all of them, if it panics where Rapier's does not, if a world
/// does not end alike to the bit on both with their events in order, or if the two hold different pairs.
#[derive(Args, Clone, Debug)]
pub(crate) struct Arguments {
    #[command(flatten)]
    common: Common,
    /// A family of worlds; may be given several times [default: all]
    #[arg(long, value_name = "NAME", value_parser = Family::ALL.map(|family| family.name))]
    only: Vec<String>,
    /// How many of the starts are checked exactly as well [default: 5; with --quick 1]
    #[arg(long, value_name = "N")]
    exact_seeds: Option<u64>,
    /// How many threads run starts side by side
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = at_least_one())]
    threads: usize,
}

/// A family in one dimension.
struct Outcome {
    family: Family,
    dim: u8,
    values: Vec<f64>,
    /// By the index of the value.
    probes: BTreeMap<usize, Probe>,
    /// The last value, by its index, at which Rapier's own does not fail, and unisize.
    thresholds: [Option<usize>; 2],
}

/// A value that was tried.
#[derive(Serialize)]
struct ProbeRow<'a> {
    dimension: u8,
    family: &'a str,
    parameter: &'a str,
    value: f64,
    starts: usize,
    rapier_failures: usize,
    unisize_failures: usize,
    alone: Discordance,
    in_order: &'a Exact,
    pairs: &'a Exact,
}

/// The threshold of a family; nothing where the first value fails already.
#[derive(Serialize)]
struct ThresholdRow<'a> {
    dimension: u8,
    family: &'a str,
    parameter: &'a str,
    neither_fails_up_to: Option<f64>,
    rapier: Option<f64>,
    unisize: Option<f64>,
    next: Option<f64>,
    /// The share of failures at the threshold, on either broad phase, is below that.
    failures_below: Option<f64>,
}

impl Arguments {
    /// Runs the study; whether unisize has passed.
    pub(crate) fn run(&self) -> Result<bool> {
        let mut output = Output::create("stability", &self.common)?;
        let pool = ThreadPoolBuilder::new().num_threads(self.threads).build()?;
        let outcomes = pool.install(|| self.outcomes());
        report(&outcomes, &mut output)
    }

    fn outcomes(&self) -> Vec<Outcome> {
        let is_meant = |family: &Family| {
            self.only.is_empty() || self.only.iter().any(|only| only == family.name)
        };
        let families = || Family::ALL.into_iter().filter(is_meant);
        let bar = progress_bar((families().count() * self.common.dims().len()) as u64);
        let mut outcomes = Vec::new();
        for &dim in self.common.dims() {
            for family in families() {
                bar.set_message(format!("{} {dim}D", family.name));
                outcomes.push(self.outcome(family, dim));
                bar.inc(1);
            }
        }
        bar.finish_and_clear();
        outcomes
    }

    fn outcome(&self, family: Family, dim: u8) -> Outcome {
        let values = family.values(self.common.usual(QUICK_VALUES, VALUES));
        let all = self.common.seeds(5, 25);
        let exact = self.exact_seeds.unwrap_or(self.common.usual(1, 5));
        let seeds = Seeds {
            exact: all.start..all.start + exact.min(all.end - all.start),
            all,
        };
        let mut probes = BTreeMap::new();
        let thresholds = [0, 1].map(|side| {
            last_sound(values.len(), |index| {
                let probe = probes.entry(index).or_insert_with(|| {
                    let case = self.shortened(family.case(values[index]));
                    match dim {
                        2 => dim2::stability::probe(&case, &seeds),
                        _ => dim3::stability::probe(&case, &seeds),
                    }
                });
                probe.failures(family.criterion)[side] == 0
            })
        });
        Outcome {
            family,
            dim,
            values,
            probes,
            thresholds,
        }
    }

    fn shortened(&self, case: Case) -> Case {
        let seconds = self.common.usual(0.5, f64::INFINITY);
        let steps = self.common.steps.unwrap_or(usize::MAX);
        case.lasting_at_most(seconds.min(steps as f64 * case.dt))
    }
}

/// Prints and writes what came of all families; whether unisize has passed.
fn report(outcomes: &[Outcome], output: &mut Output) -> Result<bool> {
    let cases = outcomes.iter().map(|outcome| outcome.probes.len()).sum();
    let mut discordance = Discordance::default();
    let mut unsound = 0;
    let mut thresholds = table([
        "world",
        "fails if",
        "parameter",
        "neither fails up to",
        "Rapier's",
        "unisize",
        "next value",
        "failed there: Rapier's",
        "unisize",
        "unisize fails alone",
        "equal to the bit, events in order",
        "equal pairs at every step",
    ]);
    for outcome in outcomes {
        let criterion = outcome.family.criterion;
        for (&index, probe) in &outcome.probes {
            discordance.count(probe, criterion);
            output.row("probe", &outcome.probe_row(index))?;
            if !probe.is_sound(criterion, cases) {
                unsound += 1;
                print_fault(outcome, index, cases);
            }
        }
        outcome.add_to(&mut thresholds, cases);
        output.row("threshold", &outcome.threshold_row())?;
    }
    println!("### Thresholds, Rapier {}\n\n{thresholds}\n", crate::RAPIER);
    let starts = outcomes[0].probes[&0].ours.len();
    println!(
        "Where none of {starts} starts fails, fewer than {} of all do, at 95 %.\n",
        percent(rarer_than(starts))
    );
    println!(
        "All {cases} values together, starts without a panic: unisize alone fails from {}, Rapier's own alone from {}. Sign test, \
         one-sided, whether unisize fails more often: p = {}.\n",
        discordance.ours,
        discordance.default,
        number(discordance.probability()),
    );
    let is_sound = unsound == 0 && !discordance.is_worse(1);
    match is_sound {
        true => println!(
            "unisize fails alone at none of {cases} values and not more often at all of them, and did what Rapier's own did wherever \
             both were compared.\n"
        ),
        false => println!("WRONG: {unsound} values, or unisize fails more often.\n"),
    }
    Ok(is_sound)
}

fn print_fault(outcome: &Outcome, index: usize, cases: usize) {
    let Outcome { family, dim, .. } = outcome;
    let probe = &outcome.probes[&index];
    let place = format!(
        "{} {dim}D at {}",
        family.name,
        number(outcome.values[index])
    );
    if probe.ours_fails_alone(family.criterion, cases) {
        println!("UNISIZE ALONE fails in {place}\n");
    }
    for (what, check) in [
        ("events in order", &probe.in_order),
        ("pairs", &probe.pairs),
    ] {
        if let Some(difference) = &check.difference {
            println!("DIFFERENCE in {place}, {what}: {difference}\n");
        }
    }
    if let Some(message) = probe.panic_alone() {
        println!("PANIC in {place} on unisize alone: {message}\n");
    }
}

impl Outcome {
    /// The last value at which neither fails.
    fn neither(&self) -> Option<usize> {
        let [default, ours] = self.thresholds;
        default.zip(ours).map(|(default, ours)| default.min(ours))
    }

    /// The first value above it, unless there is none.
    fn failing(&self) -> Option<usize> {
        let next = self.neither().map_or(0, |index| index + 1);
        self.probes.contains_key(&next).then_some(next)
    }

    fn probe_row(&self, index: usize) -> ProbeRow<'_> {
        let probe = &self.probes[&index];
        let [rapier_failures, unisize_failures] = probe.failures(self.family.criterion);
        ProbeRow {
            dimension: self.dim,
            family: self.family.name,
            parameter: self.family.parameter,
            value: self.values[index],
            starts: probe.ours.len(),
            rapier_failures,
            unisize_failures,
            alone: Discordance::of(probe, self.family.criterion),
            in_order: &probe.in_order,
            pairs: &probe.pairs,
        }
    }

    fn threshold_row(&self) -> ThresholdRow<'_> {
        let value = |index: usize| self.values[index];
        let bound = |index: usize| rarer_than(self.probes[&index].ours.len());
        ThresholdRow {
            dimension: self.dim,
            family: self.family.name,
            parameter: self.family.parameter,
            neither_fails_up_to: self.neither().map(value),
            rapier: self.thresholds[0].map(value),
            unisize: self.thresholds[1].map(value),
            next: self.failing().map(value),
            failures_below: self.neither().map(bound),
        }
    }

    fn add_to(&self, table: &mut Table, cases: usize) {
        let criterion = self.family.criterion;
        let up_to = |threshold: Option<usize>| match threshold {
            None => format!("fails at {}", number(self.values[0])),
            Some(index) if index + 1 == self.values.len() => {
                format!("{}, the last", number(self.values[index]))
            }
            Some(index) => number(self.values[index]),
        };
        let next = self.failing();
        let told = |side: usize| {
            let told = |index: usize| {
                let probe = &self.probes[&index];
                format!(
                    "{} of {}",
                    probe.failures(criterion)[side],
                    probe.ours.len()
                )
            };
            next.map_or_else(|| "-".to_owned(), told)
        };
        let alone = self.probes.values();
        let alone = alone.filter(|probe| probe.ours_fails_alone(criterion, cases));
        let sum = |check: fn(&Probe) -> &Exact| {
            let checks = self.probes.values().map(check);
            let [equal, all, by_tree] = checks.fold([0; 3], |[equal, all, by_tree], check| {
                let compared = check.runs() - check.panicked;
                [equal + check.equal, all + compared, by_tree + check.by_tree]
            });
            match by_tree {
                0 => format!("{equal} of {all}"),
                _ => format!("{equal} of {all}, {by_tree} by the tree"),
            }
        };
        table.add_row([
            format!("{} {}D", self.family.title, self.dim),
            criterion.name().to_owned(),
            self.family.parameter.to_owned(),
            up_to(self.neither()),
            up_to(self.thresholds[0]),
            up_to(self.thresholds[1]),
            next.map_or_else(|| "-".to_owned(), |index| number(self.values[index])),
            told(0),
            told(1),
            format!("{} of {}", alone.count(), self.probes.len()),
            sum(|probe| &probe.in_order),
            sum(|probe| &probe.pairs),
        ]);
    }
}
