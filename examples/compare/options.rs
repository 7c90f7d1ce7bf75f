//! The command line.

use clap::builder::RangedU64ValueParser;
use clap::{Parser, ValueEnum};
use std::path::PathBuf;
use unisize::PairFilter;
use unisize_scenes::SceneKind;

/// How many bodies `--quick` gives a scene.
const QUICK_BODIES: usize = 150;

/// How many steps `--quick` simulates.
const QUICK_STEPS: usize = 40;

/// How many steps are simulated otherwise: five seconds.
const STEPS: usize = 300;

/// Compares unisize with Rapier's own broad phase, on every scene.
///
/// The default broad phase drives the simulation, and unisize gets the same updates. After every step the pairs
/// that they hold, the contacts and intersections that follow, and what rays hit are compared. Exits with 1 if
/// anything differs.
///
/// Then whole steps are timed, with the queries made in them: each scene is simulated on either broad phase alone, the
/// two worlds stepped by turns. Their trajectories part after a while, since the solver depends on the order of
/// events; the scene stays as hard as it was, so the times are comparable in the mean. Each repeat has another seed.
/// The ratio is the median over repeats, with the lower and the upper quartile.
#[derive(Clone, Debug, Parser)]
#[command(name = "compare")]
pub(super) struct Options {
    /// A scene to compare on; may be given several times [default: every scene]
    #[arg(long = "scene", value_name = "NAME", value_parser = parse_scene)]
    scenes: Vec<SceneKind>,
    /// In how many dimensions
    #[arg(long, value_enum, default_value = "both")]
    dim: Dim,
    /// About how many bodies in every scene [default: each scene's own number]
    #[arg(long, value_name = "N", value_parser = between(1, 10_000_000))]
    bodies: Option<usize>,
    /// How many steps to simulate [default: 300, or 40 with --quick]
    #[arg(long, value_name = "N", value_parser = between(1, 1_000_000))]
    steps: Option<usize>,
    /// What finds the pairs in unisize
    #[arg(long, value_enum, default_value = "grid-sweep")]
    pub(super) kernel: Kernel,
    /// Which pairs unisize leaves out because they can have no effect
    #[arg(long, value_enum, default_value = crate::FILTER)]
    pub(super) filter: Filter,
    /// How many threads unisize may use, which pays only for very many bodies, and Rapier if it is built with `parallel`
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = between(1, 1_024))]
    pub(super) threads: usize,
    /// How many rays are cast after each step, in the tree of the broad phase, beside those of the scene itself
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = between(0, 1_000_000))]
    pub(super) rays: usize,
    /// How often whole steps are timed; to tell a few per cent takes nine, and 0 leaves it out
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = between(0, 1_000))]
    pub(super) repeats: usize,
    /// The seed of the scenes' randomness; repeats count up from it
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(super) seed: u64,
    /// Write the results to this file as well
    #[arg(long, value_name = "FILE")]
    pub(super) json: Option<PathBuf>,
    /// Few bodies and steps, for a check of a minute
    #[arg(long)]
    quick: bool,
    /// Check unisize's internal invariants after every step
    #[arg(long)]
    pub(super) validate: bool,
    /// Compute and compare the contacts only at every N-th step and the last
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = between(1, 1_000_000))]
    pub(super) contacts_every: usize,
}

impl Options {
    pub(super) fn dims(&self) -> impl Iterator<Item = u8> {
        let dims: &[u8] = match self.dim {
            Dim::Two => &[2],
            Dim::Three => &[3],
            Dim::Both => &[2, 3],
        };
        dims.iter().copied()
    }

    pub(super) fn scenes(&self) -> impl Iterator<Item = SceneKind> {
        let scenes = if self.scenes.is_empty() {
            SceneKind::ALL.to_vec()
        } else {
            self.scenes.clone()
        };
        scenes.into_iter()
    }

    pub(super) fn bodies(&self, kind: SceneKind) -> usize {
        self.bodies.unwrap_or(if self.quick {
            QUICK_BODIES
        } else {
            kind.default_bodies()
        })
    }

    pub(super) fn steps(&self) -> usize {
        self.steps
            .unwrap_or(if self.quick { QUICK_STEPS } else { STEPS })
    }

    /// All steps of all simulations.
    pub(super) fn total_steps(&self) -> usize {
        let runs = 1 + 2 * self.repeats;
        self.dims().count() * self.scenes().count() * self.steps() * runs
    }
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Dim {
    #[value(name = "2")]
    Two,
    #[value(name = "3")]
    Three,
    Both,
}

/// The kernels of unisize.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum Kernel {
    /// The fast one
    GridSweep,
    /// The algorithm of Capannini and Larsson
    RankSweep,
    /// Every box against every other
    BruteForce,
}

/// Which pairs unisize leaves out.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum Filter {
    /// None
    Off,
    /// Those of one body, and of types of bodies that cannot meet
    Bodies,
    /// Also those whose groups forbid it
    Groups,
    /// Also those whose shapes cannot meet
    Shapes,
}

impl From<Filter> for PairFilter {
    fn from(filter: Filter) -> Self {
        match filter {
            Filter::Off => Self::Off,
            Filter::Bodies => Self::Bodies,
            Filter::Groups => Self::Groups,
            Filter::Shapes => Self::Shapes,
        }
    }
}

impl Kernel {
    pub(super) fn name(self) -> String {
        let value = self.to_possible_value();
        value.map_or_else(String::new, |value| value.get_name().to_owned())
    }
}

fn between(low: u64, high: u64) -> RangedU64ValueParser<usize> {
    RangedU64ValueParser::new().range(low..=high)
}

fn parse_scene(name: &str) -> Result<SceneKind, String> {
    SceneKind::from_name(name).ok_or_else(|| {
        let names = SceneKind::ALL.map(SceneKind::name).join(", ");
        format!("there is no such scene; there are {names}")
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
        assert_eq!(options.scenes().count(), SceneKind::ALL.len());
        assert_eq!(options.dims().collect::<Vec<_>>(), [2, 3]);
        assert_eq!(
            (options.steps(), options.repeats, options.rays),
            (300, 3, 0)
        );
        assert_eq!(options.bodies(SceneKind::TileMap), 500);
        assert_eq!(options.total_steps(), SceneKind::ALL.len() * 2 * 300 * 7);
    }

    #[test]
    fn scenes_are_selected() {
        let options =
            parse("--scene ghosts --scene tile-map --dim 2 --rays 8 --repeats 0").unwrap();
        let scenes = [SceneKind::Ghosts, SceneKind::TileMap];
        assert_eq!(options.scenes().collect::<Vec<_>>(), scenes);
        assert_eq!(options.rays, 8);
        assert_eq!(options.total_steps(), 2 * 300);
    }

    #[test]
    fn quick_is_the_default_of_sizes_only() {
        let options = parse("--quick").unwrap();
        assert_eq!(options.bodies(SceneKind::Gas), QUICK_BODIES);
        assert_eq!(options.steps(), QUICK_STEPS);
        let options = parse("--quick --bodies 7 --steps 9").unwrap();
        assert_eq!((options.bodies(SceneKind::Gas), options.steps()), (7, 9));
    }

    #[test]
    fn what_makes_no_sense_is_refused() {
        for arguments in [
            "--scene nowhere",
            "--bodies 0",
            "--repeats -1",
            "--rays many",
        ] {
            assert!(parse(arguments).is_err(), "{arguments}");
        }
        let error = parse("--scene nowhere").unwrap_err().to_string();
        assert!(error.contains("tile-map"), "{error}");
    }
}
