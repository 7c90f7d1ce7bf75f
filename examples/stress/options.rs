//! The command line.

use crate::case::Case;
use crate::family::Family;
use clap::builder::RangedU64ValueParser;
use clap::{Parser, ValueEnum};
use std::path::PathBuf;

/// Starts of each case, and those of them that are checked exactly as well.
const SEEDS: usize = 25;
const EXACT_SEEDS: usize = 5;

/// With `--quick`: nine against none is significant among up to 243 cases.
const QUICK_SEEDS: usize = 9;
const QUICK_EXACT_SEEDS: usize = 1;
const QUICK_SECONDS: f64 = 0.5;

/// Bodies of a world that is shifted.
const BODIES: usize = 10_000;
const QUICK_BODIES: usize = 500;

/// Takes small worlds to their limits on Rapier's own broad phase and on unisize.
///
/// Exits with 1 if unisize fails alone in a case or more often in all of them, if it panics where Rapier's does not, if a world does
/// not end alike to the bit on both with their events in order, or if the two hold different pairs.
#[derive(Clone, Debug, Parser)]
#[command(name = "stress")]
pub(super) struct Options {
    /// A family of cases; may be given several times [default: all of them, and the shifts]
    #[arg(long = "case", value_name = "FAMILY", value_parser = parse_family)]
    families: Vec<Subject>,
    /// In how many dimensions
    #[arg(long, value_enum, default_value = "both")]
    dim: Dim,
    /// From how many starts each case is run on either broad phase [default: 25; with --quick 9]
    #[arg(long, value_name = "N", value_parser = between(1, 1_000_000))]
    seeds: Option<usize>,
    /// How many of these starts are checked exactly as well [default: 5; with --quick 1]
    #[arg(long, value_name = "N", value_parser = between(0, 1_000_000))]
    exact_seeds: Option<usize>,
    /// The first seed
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(super) seed: u64,
    /// How many bodies a world has that is shifted [default: 10,000; with --quick 500]
    #[arg(long, value_name = "N", value_parser = between(1, 10_000_000))]
    bodies: Option<usize>,
    /// The folder of the charts [default: docs/figures; with --quick stress in the target directory]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Few starts and half a second of each, for a check of some seconds
    #[arg(long)]
    quick: bool,
}

/// What can be asked for by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Subject {
    Family(Family),
    Shifts,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Dim {
    #[value(name = "2")]
    Two,
    #[value(name = "3")]
    Three,
    Both,
}

impl Options {
    pub(super) fn dims(&self) -> &'static [u8] {
        match self.dim {
            Dim::Two => &[2],
            Dim::Three => &[3],
            Dim::Both => &[2, 3],
        }
    }

    fn has(&self, subject: Subject) -> bool {
        self.families.is_empty() || self.families.contains(&subject)
    }

    pub(super) fn families(&self) -> impl Iterator<Item = Family> {
        let families = Family::ALL.into_iter();
        families.filter(|&family| self.has(Subject::Family(family)))
    }

    /// Whether worlds are shifted as well.
    pub(super) fn has_shifts(&self) -> bool {
        self.has(Subject::Shifts)
    }

    /// The cases of a family.
    pub(super) fn cases(&self, family: Family) -> Vec<Case> {
        let cases = family.cases().into_iter();
        let seconds = if self.quick {
            QUICK_SECONDS
        } else {
            f64::INFINITY
        };
        cases.map(|case| case.lasting_at_most(seconds)).collect()
    }

    /// The seeds of the starts.
    pub(super) fn seeds(&self) -> impl Iterator<Item = u64> {
        let default = if self.quick { QUICK_SEEDS } else { SEEDS };
        self.counted(self.seeds.unwrap_or(default))
    }

    /// Those of them that are checked exactly.
    pub(super) fn exact_seeds(&self) -> impl Iterator<Item = u64> {
        let default = if self.quick {
            QUICK_EXACT_SEEDS
        } else {
            EXACT_SEEDS
        };
        self.counted(self.exact_seeds.unwrap_or(default))
    }

    fn counted(&self, count: usize) -> impl Iterator<Item = u64> + use<> {
        let first = self.seed;
        (0..count as u64).map(move |index| first.wrapping_add(index))
    }

    pub(super) fn bodies(&self) -> usize {
        let default = if self.quick { QUICK_BODIES } else { BODIES };
        self.bodies.unwrap_or(default)
    }

    /// The folder of the charts, of a full run: only that of the version whose charts are published has one by default.
    pub(super) fn out(&self) -> PathBuf {
        let default = || match self.quick || !crate::HAS_CHARTS {
            true => unisize_charts::scratch_folder("stress"),
            false => PathBuf::from("docs/figures"),
        };
        self.out.clone().unwrap_or_else(default)
    }

    /// How many runs there are of one case.
    pub(super) fn runs(&self) -> usize {
        2 * self.seeds().count() + 3 * self.exact_seeds().count()
    }

    /// How many cases there are in each dimension.
    pub(super) fn total_cases(&self) -> usize {
        let families = self.families();
        families.map(|family| self.cases(family).len()).sum()
    }
}

fn between(low: u64, high: u64) -> RangedU64ValueParser<usize> {
    RangedU64ValueParser::new().range(low..=high)
}

fn parse_family(name: &str) -> Result<Subject, String> {
    const SHIFTS: &str = "shifts";
    if name == SHIFTS {
        return Ok(Subject::Shifts);
    }
    let mut families = Family::ALL.into_iter();
    let found = families.find(|family| family.name() == name);
    found.map(Subject::Family).ok_or_else(|| {
        let names = Family::ALL.map(Family::name).join(", ");
        format!("there is no such family; there are {names} and {SHIFTS}")
    })
}

#[cfg(test)]
impl Options {
    /// As many starts as a quick run has, for tests.
    pub(super) fn quick() -> Self {
        Self::parse_from(["stress", "--quick"])
    }
}

#[cfg(test)]
mod tests {
    use super::Options;
    use crate::family::Family;
    use clap::Parser;
    use std::path::Path;

    fn parse(line: &str) -> Result<Options, clap::Error> {
        Options::try_parse_from(["stress"].into_iter().chain(line.split_whitespace()))
    }

    #[test]
    fn a_quick_run_leaves_the_published_charts_alone() {
        assert!(!parse("--quick").unwrap().out().starts_with("docs"));
        let out = parse("--quick --out docs").unwrap().out();
        assert_eq!(out, Path::new("docs"));
    }

    #[test]
    fn families_are_selected() {
        let options = parse("").unwrap();
        assert_eq!(options.families().count(), Family::ALL.len());
        assert!(options.has_shifts());
        let options = parse("--case spins --case shifts").unwrap();
        assert_eq!(options.families().collect::<Vec<_>>(), [Family::Spins]);
        assert!(options.has_shifts());
        assert!(!parse("--case spins").unwrap().has_shifts());
        assert!(parse("--case spin").is_err());
    }

    #[test]
    fn seeds_count_up() {
        let options = parse("--seeds 3 --exact-seeds 2 --seed 7").unwrap();
        assert_eq!(options.seeds().collect::<Vec<_>>(), [7, 8, 9]);
        assert_eq!(options.exact_seeds().collect::<Vec<_>>(), [7, 8]);
        assert_eq!(options.runs(), 12);
    }
}
