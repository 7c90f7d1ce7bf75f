//! The command line.

use crate::case::Case;
use clap::Parser;
use clap::builder::RangedU64ValueParser;
use std::path::PathBuf;
use unisize::PairFilter;
use unisize_scenes::SceneKind;

/// The number of bodies of a scene with `--quick`.
const QUICK_BODIES: usize = 150;

/// The number of steps with `--quick`.
const QUICK_STEPS: usize = 40;

/// The number of steps otherwise: a second.
const STEPS: usize = 60;

/// The number of steps with `--full`: five seconds.
const FULL_STEPS: usize = 300;

/// Compares unisize with Rapier's own broad phase, on every scene.
///
/// The default broad phase drives the simulation, and unisize gets the same updates. After every step the program compares the pairs
/// that both hold, the contacts and intersections that follow, and the hits of rays. It exits with 1 if anything differs.
///
/// Then it times whole steps with their queries: it simulates each scene on either broad phase alone, and steps the two worlds even/odd
/// interleaved. Their trajectories diverge after a while, since the solver depends on the order of events; the scene stays as hard as it
/// was, so the times are comparable in the mean. Each repeat has another seed. The ratio is the median over repeats, with the lower and
/// the upper quartile.
///
/// `limit` is the ratio with a broad phase that takes no time: D / (D - B), with D the default's whole step and B the part of its broad
/// phase, both of one more world on the default alone, whose broad phase is timed. `without contact` is the number of pairs without an
/// active contact and without an intersection in the narrow phase of either world at the end of the first repeat. Pairs, contacts and the
/// times of the broad phase are those of simulations that the default drives. The first update, which inserts all colliders, is timed
/// apart. On one thread, all times are processor times.
#[derive(Clone, Debug, Parser)]
#[command(name = "compare")]
pub(super) struct Options {
    /// A scene, or one with a number of bodies, as in pyramid-8000; may be given several times [default: every
    /// scene, and some with 8000 bodies too unless there is --quick]
    #[arg(long = "scene", value_name = "NAME", value_parser = parse_case)]
    cases: Vec<Case>,
    /// In how many dimensions, 2 or 3 [default: both]
    #[arg(long, value_parser = clap::value_parser!(u8).range(2..=3))]
    dim: Option<u8>,
    /// How many steps to simulate [default: 60, or 40 with --quick, or 300 with --full]
    #[arg(long, value_name = "N", value_parser = between(1, 1_000_000))]
    steps: Option<usize>,
    /// Which steps are checked and timed, as in 600..720; the steps before are made on unisize alone [default: from the first one on]
    #[arg(long, value_name = "A..B", value_parser = parse_window, conflicts_with = "steps")]
    window: Option<Window>,
    /// Which pairs without an effect unisize leaves out: none, those of one body and of types of bodies that cannot meet, also those whose
    /// groups forbid it, or also those whose shapes cannot meet
    #[arg(long, default_value = crate::FILTER, value_parser = ["off", "bodies", "groups", "shapes"])]
    pub(super) filter: String,
    /// The number of threads for unisize, and for Rapier if it is built with `parallel`
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = between(1, 1_024))]
    pub(super) threads: usize,
    /// The number of rays per step, in the tree of the broad phase, in addition to those of the scene itself
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = between(0, 1_000_000))]
    pub(super) rays: usize,
    /// How often whole steps are timed; differences of a few per cent take nine, 0 leaves it out, and all repeats are in memory at once [default: 1, or 3 with --full]
    #[arg(long, value_name = "N", value_parser = between(0, 100))]
    repeats: Option<usize>,
    /// Append the results to this file, a JSON object a line
    #[arg(long, value_name = "FILE")]
    pub(super) json: Option<PathBuf>,
    /// Few bodies and steps, for a check of a minute
    #[arg(long)]
    quick: bool,
    /// More steps and repeats: a thorough check of half an hour
    #[arg(long, conflicts_with = "quick")]
    full: bool,
}

/// Steps of a simulation.
#[derive(Clone, Copy, Debug)]
struct Window {
    before: usize,
    steps: usize,
}

impl Options {
    pub(super) fn dims(&self) -> impl Iterator<Item = u8> {
        self.dim.map_or(2..=3, |dim| dim..=dim)
    }

    pub(super) fn cases(&self) -> impl Iterator<Item = Case> {
        let mut cases = self.cases.clone();
        if cases.is_empty() {
            cases.extend(Case::all());
            // Where all have one number of bodies, there is no second one.
            if !self.quick {
                cases.extend(Case::large());
            }
        }
        cases.into_iter()
    }

    pub(super) fn bodies(&self, case: Case) -> usize {
        let usual = if self.quick {
            QUICK_BODIES
        } else {
            case.kind.default_bodies()
        };
        case.bodies.unwrap_or(usual)
    }

    pub(super) fn steps(&self) -> usize {
        let usual = match (self.quick, self.full) {
            (true, _) => QUICK_STEPS,
            (_, true) => FULL_STEPS,
            _ => STEPS,
        };
        let of_window = self.window.map(|window| window.steps);
        self.steps.or(of_window).unwrap_or(usual)
    }

    pub(super) fn before(&self) -> usize {
        self.window.map_or(0, |window| window.before)
    }

    pub(super) fn repeats(&self) -> usize {
        self.repeats.unwrap_or(if self.full { 3 } else { 1 })
    }

    pub(super) fn pair_filter(&self) -> PairFilter {
        match self.filter.as_str() {
            "off" => PairFilter::Off,
            "bodies" => PairFilter::Bodies,
            "groups" => PairFilter::Groups,
            _ => PairFilter::Shapes,
        }
    }
}

fn between(low: u64, high: u64) -> RangedU64ValueParser<usize> {
    RangedU64ValueParser::new().range(low..=high)
}

fn parse_window(range: &str) -> Result<Window, String> {
    let (start, end) = range.split_once("..").unzip();
    let [start, end] = [start, end].map(|number| number?.parse::<u32>().ok());
    match (start, end) {
        (Some(start), Some(end)) if start < end && end <= 1_000_000 => Ok(Window {
            before: start as usize,
            steps: (end - start) as usize,
        }),
        _ => Err("a window is two numbers of steps, as in 600..720, up to a million".to_owned()),
    }
}

fn parse_case(name: &str) -> Result<Case, String> {
    Case::from_name(name).ok_or_else(|| {
        let names = SceneKind::ALL.map(SceneKind::name).join(", ");
        format!("there is no such scene; there are {names}, and each with a number of bodies, as in pyramid-8000")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(arguments: &str) -> Result<Options, clap::Error> {
        Options::try_parse_from(["compare"].into_iter().chain(arguments.split_whitespace()))
    }

    #[test]
    fn everything_is_compared_by_default() {
        let options = parse("").unwrap();
        let count = SceneKind::ALL.len() + 3;
        assert_eq!(options.cases().count(), count);
        assert_eq!(options.dims().collect::<Vec<_>>(), [2, 3]);
        assert_eq!(options.bodies(SceneKind::TileMap.into()), 500);
        assert!(Case::large().all(|case| options.bodies(case) == 8_000));
        assert_eq!((options.steps(), options.repeats()), (60, 1));
        let options = parse("--full").unwrap();
        assert_eq!((options.steps(), options.repeats()), (300, 3));
    }

    #[test]
    fn quick_is_the_default_of_sizes_only() {
        let gas = SceneKind::Gas.into();
        let options = parse("--quick").unwrap();
        assert_eq!(options.cases().count(), SceneKind::ALL.len());
        let sizes = (options.bodies(gas), options.steps());
        assert_eq!(sizes, (QUICK_BODIES, QUICK_STEPS));
        // A number in the name goes first.
        let options = parse("--quick --steps 9 --scene gas --scene gas-8").unwrap();
        let bodies: Vec<_> = options.cases().map(|case| options.bodies(case)).collect();
        assert_eq!((bodies, options.steps()), (vec![QUICK_BODIES, 8], 9));
    }

    #[test]
    fn a_window_says_which_steps_are_timed() {
        let options = parse("--window 600..720").unwrap();
        assert_eq!((options.before(), options.steps()), (600, 120));
        assert_eq!(parse("").unwrap().before(), 0);
    }

    #[test]
    fn what_makes_no_sense_is_refused() {
        for arguments in [
            "--scene nowhere",
            "--scene gas-0",
            "--dim 4",
            "--filter all",
            "--quick --full",
            "--window 9",
            "--window 9..9",
            "--window 9..10 --steps 3",
        ] {
            assert!(parse(arguments).is_err(), "{arguments}");
        }
        let error = parse("--scene nowhere").unwrap_err().to_string();
        assert!(error.contains("tile-map"), "{error}");
    }
}
