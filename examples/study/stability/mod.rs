//! Where small worlds fail, does unisize fail alone?
//!
//! Small worlds are taken to their limits: high stacks, heavy things on light ones, chains with a heavy end, long time steps, places
//! far from the origin, tiny and huge sizes, fast spin and flight. What leaves nothing to chance comes first: side by side on both
//! broad phases, with the events of each update in order, worlds must hold the same pairs after each step and end equal to the bit;
//! and unisize must not panic where Rapier's own does not.
//!
//! Then, for each family of worlds, a bisection on either broad phase finds its *threshold*: the largest value of its parameter at
//! which no start fails. Whether unisize fails more often is told for each value, and for all of them together.

pub(crate) mod case;
pub(crate) mod caught;
pub(crate) mod family;
pub(crate) mod probe;
mod threshold;

use crate::options::Common;
use crate::output::Output;
use crate::progress::progress_bar;
use crate::statistics::rarer_than;
use crate::{dim2, dim3};
use anyhow::Result;
use case::Case;
use clap::Args;
use family::Family;
use probe::{Alone, Equality, Probe};
use rayon::ThreadPoolBuilder;
use std::collections::BTreeMap;
use threshold::last_sound;

/// How many values there are between the ends of a family's range, of a quick run and of a full one.
const VALUES: [usize; 2] = [5, 65];

/// From how many starts both are compared step by step.
const COMPARED: [u64; 2] = [1, 5];

/// Where small worlds fail, does unisize fail alone?
///
/// Exits with 1 if a world is not the same on both with their events in order, if unisize panics where Rapier's own does not, or if
/// it fails alone at any value, or more often at all of them.
#[derive(Args, Clone, Debug)]
pub(crate) struct Arguments {
    #[command(flatten)]
    common: Common,
    /// A family of worlds; may be given several times [default: all]
    #[arg(long, value_name = "NAME", value_parser = Family::ALL.map(|family| family.name))]
    only: Vec<String>,
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

impl Arguments {
    /// Runs the study, on all processors, as no time counts; whether unisize has passed.
    pub(crate) fn run(&self) -> Result<bool> {
        let mut output = Output::create("stability", &self.common)?;
        let pool = ThreadPoolBuilder::new().build()?;
        let outcomes = pool.install(|| self.outcomes());
        for outcome in &outcomes {
            outcome.report(&mut output)?;
        }
        conclude(&outcomes, &mut output)
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
        let values = family.values(self.common.usual(VALUES));
        let compared = self.common.usual(COMPARED);
        let mut probes = BTreeMap::new();
        let thresholds = [0, 1].map(|side| {
            last_sound(values.len(), |index| {
                let probe = probes.entry(index).or_insert_with(|| {
                    let case = self.shortened(family.case(values[index]));
                    let starts = self.common.seeds([5, 25]);
                    match dim {
                        2 => dim2::stability::probe(&case, starts, compared),
                        _ => dim3::stability::probe(&case, starts, compared),
                    }
                });
                probe.failures()[side] == 0
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
        let seconds = self.common.usual([0.5, f64::INFINITY]);
        let steps = self.common.steps.unwrap_or(usize::MAX);
        case.lasting_at_most(seconds.min(steps as f64 * case.dt))
    }
}

impl Outcome {
    /// The last value at which neither fails.
    fn neither(&self) -> Option<usize> {
        let [default, ours] = self.thresholds;
        default.zip(ours).map(|(default, ours)| default.min(ours))
    }

    /// The first value above it, unless there is none.
    fn next(&self) -> Option<usize> {
        let next = self.neither().map_or(0, |index| index + 1);
        self.probes.contains_key(&next).then_some(next)
    }

    fn report(&self, output: &mut Output) -> Result<()> {
        let case = self.family.case(self.values[0]);
        let value = |index: Option<usize>| index.map(|index| self.values[index]).into();
        let failures = |side: usize| {
            let next = self.next().map(|index| self.probes[&index].failures());
            next.map(|failures| failures[side]).into()
        };
        output.row(
            "family",
            &[
                ("dimension", self.dim.into()),
                ("world", self.family.title.into()),
                ("fails_if", case.setup.fails_if().into()),
                ("parameter", self.family.parameter.into()),
                ("equality", self.equality().into()),
                ("neither", value(self.neither())),
                ("next", value(self.next())),
                ("rapier", value(self.thresholds[0])),
                ("unisize", value(self.thresholds[1])),
                ("rapier_failures", failures(0)),
                ("unisize_failures", failures(1)),
                ("starts", self.probes[&0].ends.len().into()),
                ("values", self.probes.len().into()),
            ],
        )
    }

    /// In how many runs, of those in which Rapier's own did not panic, both were the same.
    fn equality(&self) -> String {
        let sum = |count: fn(&Equality) -> usize| -> usize {
            let probes = self.probes.values();
            probes.map(|probe| count(&probe.equality)).sum()
        };
        let [equal, by_tree] = [sum(|of| of.equal), sum(|of| of.by_tree)];
        let all = equal + by_tree + sum(|of| of.differing);
        match by_tree {
            0 => format!("{equal} of {all}"),
            _ => format!("{equal} of {all}, {by_tree} by the tree"),
        }
    }

    /// What is wrong at any of its values, which are some of so many.
    fn faults(&self, all: usize) -> Vec<String> {
        let mut faults = Vec::new();
        for (&index, probe) in self.probes.iter().filter(|(_, of)| !of.is_sound(all)) {
            let (name, value) = (self.family.name, self.values[index]);
            let place = format!("{name} {}D at {value}", self.dim);
            let difference = probe.equality.difference.iter();
            faults.extend(difference.map(|what| format!("DIFFERENCE in {place}: {what}")));
            let panic = probe.panic_alone().into_iter();
            faults.extend(panic.map(|what| format!("PANIC on unisize alone in {place}: {what}")));
            if probe.alone().is_worse(all) {
                faults.push(format!("UNISIZE ALONE fails in {place}"));
            }
        }
        faults
    }
}

/// Judges all values together, and says how little would have been noticed; whether unisize has passed.
fn conclude(outcomes: &[Outcome], output: &mut Output) -> Result<bool> {
    let values: usize = outcomes.iter().map(|outcome| outcome.probes.len()).sum();
    let mut alone = Alone::default();
    let probes = outcomes.iter().flat_map(|outcome| outcome.probes.values());
    probes.for_each(|probe| alone += probe.alone());
    let starts = outcomes[0].probes[&0].ends.len();
    output.row(
        "all",
        &[
            ("values", values.into()),
            ("starts", starts.into()),
            ("rarer_than", rarer_than(starts).into()),
            ("rapier_alone", alone.default.into()),
            ("unisize_alone", alone.ours.into()),
            ("p", alone.probability().into()),
            ("noticed_at_one_value", Alone::noticed(values).into()),
            ("noticed_at_all", Alone::noticed(1).into()),
        ],
    )?;
    let faults: Vec<_> = outcomes.iter().flat_map(|of| of.faults(values)).collect();
    println!("\n{}", faults.join("\n"));
    println!(
        "Where none of {starts} starts fails, fewer than one in {:.0} of all do, at 95 %. That unisize fails alone would have been \
         noticed from {} starts on at one value, and from {} at all {values} together.",
        1.0 / rarer_than(starts),
        Alone::noticed(values),
        Alone::noticed(1),
    );
    let is_sound = faults.is_empty() && !alone.is_worse(1);
    let verdict = match is_sound {
        true => "does what Rapier's own does, and fails no more often.",
        false => "DIFFERS from Rapier's own, or fails more often.",
    };
    println!("unisize {verdict}");
    Ok(is_sound)
}
