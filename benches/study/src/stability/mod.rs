//! Where small worlds fail, does unisize fail alone?
//!
//! The study takes small worlds to their limits: high stacks, heavy bodies on light ones, chains with a heavy end, long time steps, places
//! far from the origin, tiny and huge sizes, fast spin and flight. Some checks leave nothing to chance: side by side on both broad phases,
//! with the events of each update in order, worlds must hold the same pairs after each step and end equal to the bit; and unisize must not
//! panic where Rapier's own does not.
//!
//! For each family of worlds, a bisection on either broad phase finds its *threshold*: the largest value of its parameter at which no
//! start fails. A test decides whether unisize fails more often, at each value and at all of them together.

pub(crate) mod case;
pub(crate) mod caught;
pub(crate) mod family;
pub(crate) mod probe;

use crate::options::Common;
use crate::output::Output;
use crate::statistics::rarer_than;
use crate::{dim2, dim3};
use anyhow::Result;
use case::Case;
use family::Family;
use probe::{Alone, Equality, Probe};
use rayon::ThreadPoolBuilder;
use std::collections::BTreeMap;

/// The number of values from one end of a family's range to the other, in a quick run and in a full one.
const VALUES: [usize; 2] = [5, 65];

/// The number of starts from which both are compared step by step.
const COMPARED: [u64; 2] = [1, 5];

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

/// Runs the study, on all processors, as no time counts; whether unisize has passed.
pub(crate) fn run(common: &Common) -> Result<bool> {
    let mut output = Output::create(common)?;
    let pool = ThreadPoolBuilder::new().build()?;
    let outcomes = common.each(
        &Family::ALL,
        |family| family.name,
        |dim, &family| pool.install(|| outcome(common, family, dim)),
    );
    for outcome in &outcomes {
        outcome.report(&mut output)?;
    }
    conclude(&outcomes, &mut output)
}

fn outcome(common: &Common, family: Family, dim: u8) -> Outcome {
    let values = family.values(common.usual(VALUES));
    let compared = common.usual(COMPARED);
    let mut probes = BTreeMap::new();
    let thresholds = [0, 1].map(|side| {
        last_sound(values.len(), |index| {
            let probe = probes.entry(index).or_insert_with(|| {
                let case = shortened(common, family.case(values[index]));
                let starts = common.seeds([5, 25]);
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

fn shortened(common: &Common, case: Case) -> Case {
    let seconds = common.usual([0.5, f64::INFINITY]);
    let steps = common.steps.unwrap_or(usize::MAX);
    case.lasting_at_most(seconds.min(steps as f64 * case.dt))
}

impl Outcome {
    fn report(&self, output: &mut Output) -> Result<()> {
        // The last value at which neither fails, and the first one above it.
        let [default, ours] = self.thresholds;
        let neither = default.zip(ours).map(|(default, ours)| default.min(ours));
        let next = neither.map_or(0, |index| index + 1);
        let value = |index: Option<usize>| index.map(|index| self.values[index]).into();
        output.row(
            "family",
            &[
                ("dimension", self.dim.into()),
                ("world", self.family.title.into()),
                ("parameter", self.family.parameter.into()),
                ("equality", self.equality().into()),
                ("neither", value(neither)),
                (
                    "next",
                    value(self.probes.contains_key(&next).then_some(next)),
                ),
                ("rapier", value(default)),
                ("unisize", value(ours)),
                ("starts", self.probes[&0].ends.len().into()),
                ("values", self.probes.len().into()),
            ],
        )
    }

    /// The number of equal runs, of those in which Rapier's own did not panic.
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

    /// The faults at its values, which are a part of `all` values.
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

/// Judges all values together, and prints the smallest effect that the tests would notice. Returns whether unisize has passed.
fn conclude(outcomes: &[Outcome], output: &mut Output) -> Result<bool> {
    let values: usize = outcomes.iter().map(|outcome| outcome.probes.len()).sum();
    let alone = Alone::of(outcomes.iter().flat_map(|outcome| outcome.probes.values()));
    let starts = outcomes[0].probes[&0].ends.len();
    output.row(
        "all",
        &[
            ("values", values.into()),
            ("starts", starts.into()),
            ("rapier_alone", alone.default.into()),
            ("unisize_alone", alone.ours.into()),
            ("p", alone.probability().into()),
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

/// The last sound index of `count`, if the first indices are sound; `None` if the first one is not. **O(log count)** questions.
///
/// Near the limit worlds are chaotic, so that a larger value may hold where a smaller one fails. The result is a value that holds and whose
/// neighbour fails, but not the only such value.
fn last_sound(count: usize, mut is_sound: impl FnMut(usize) -> bool) -> Option<usize> {
    let [mut sound, mut failing] = [0, count.checked_sub(1)?];
    if !is_sound(sound) {
        return None;
    }
    if is_sound(failing) {
        return Some(failing);
    }
    while failing - sound > 1 {
        let middle = sound.midpoint(failing);
        match is_sound(middle) {
            true => sound = middle,
            false => failing = middle,
        }
    }
    Some(sound)
}

#[cfg(test)]
mod tests {
    use super::last_sound;

    #[test]
    fn the_last_sound_one_is_found_in_few_steps() {
        for count in 1..40 {
            for sound in 0..=count {
                let mut asked = 0;
                let found = last_sound(count, |index| {
                    asked += 1;
                    index < sound
                });
                assert_eq!(found, sound.checked_sub(1));
                assert!(asked <= 3 + count.ilog2() as usize, "{count} {asked}");
            }
        }
        assert_eq!(last_sound(0, |_| true), None);
    }
}
