//! The levels of the filter, and sets of axes in the place of its last one: pairs held against time.
//!
//! ```text
//! cargo run --release --package compare-opened --example precision -- --levels
//! ```
//!
//! Each scene is stepped on unisize at each level, step by step in turns. A set of axes that unisize does not have is a sieve behind
//! the level `Groups`, whose own time does not count. Draws `docs/figures/levels.svg`.

use crate::report::Report;
use crate::{Test, dim2, dim3};
use anyhow::Result;
use std::io;
use std::path::Path;
use std::time::Duration;
use unisize::PairFilter;
use unisize_charts::{Axis, Chart, Panel, Series, color};
use unisize_scenes::SceneKind;

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/figures/levels.svg");

pub(crate) const STEPS: usize = 120;

/// Steps that are not counted.
pub(crate) const WARM_UP: usize = 20;

/// Races in each scene; of each figure the median counts.
const ROUNDS: usize = 3;

const SCENES: [(SceneKind, usize); 6] = [
    (SceneKind::Gas, 2000),
    (SceneKind::FallingBalls, 1000),
    (SceneKind::Ropes, 500),
    (SceneKind::MixedOneAndAHalf, 1000),
    (SceneKind::Stacks, 500),
    (SceneKind::Chains, 1000),
];

/// A level of the filter, or a test behind one.
pub(crate) struct Level {
    name: &'static str,
    pub(crate) filter: PairFilter,
    pub(crate) test: Option<Test>,
}

fn levels(dim: u8) -> Vec<Level> {
    use PairFilter::{Groups, Off, Shapes};
    let dops: &[_] = match dim {
        2 => &[("8-DOP", Test::Corners)],
        _ => &[
            ("14-DOP", Test::Corners),
            ("18-DOP", Test::Edges),
            ("26-DOP", Test::Both),
        ],
    };
    let own = [("Groups", Groups), ("Off", Off), ("Shapes", Shapes)];
    let own = own.map(|(name, filter)| Level {
        name,
        filter,
        test: None,
    });
    let [boxes, balls] = [
        ("boxes without margins", Test::Boxes),
        ("bounding balls", Test::Balls),
    ];
    let [axes, distance] = [
        ("axes of Shapes", Test::Points),
        ("exact distance", Test::Distance),
    ];
    let sieves = [boxes, balls].into_iter().chain(dops.iter().copied());
    let sieves = sieves.chain([axes, distance]);
    let sieves = sieves.map(|(name, test)| Level {
        name,
        filter: Groups,
        test: Some(test),
    });
    own.into_iter().chain(sieves).collect()
}

/// Of the counted steps of one race.
#[derive(Clone, Copy, Default)]
pub(crate) struct Figures {
    pub(crate) pairs: usize,
    pub(crate) contacts: usize,
    pub(crate) broad: Duration,
    /// All of the step but the broad phase.
    pub(crate) rest: Duration,
}

/// Pairs held per contact, and the times of the broad phase, of the rest and of the whole step, in milliseconds a step. Of several
/// scenes geometric means, in which times are over those of the first level, and pairs of scenes in which nothing touches do not
/// count.
type Row = [f64; 4];

/// The medians of several races.
fn row(races: &[Figures]) -> Row {
    let [broad, rest] = [|race: &Figures| race.broad, |race: &Figures| race.rest].map(|time| {
        let mut times: Vec<_> = races.iter().map(time).collect();
        times.sort_unstable();
        1.0e3 * times[times.len() / 2].as_secs_f64() / (STEPS - WARM_UP) as f64
    });
    let pairs = races[0].pairs as f64 / races[0].contacts as f64;
    [pairs, broad, rest, broad + rest]
}

fn mean(scenes: &[Vec<Row>], level: usize) -> Row {
    std::array::from_fn(|k| {
        let first = |scene: &[Row]| if k == 0 { 1.0 } else { scene[0][k] };
        let values = scenes
            .iter()
            .map(|scene| (scene[level][k] / first(scene)).ln());
        let values: Vec<_> = values.filter(|value| value.is_finite()).collect();
        (values.iter().sum::<f64>() / values.len() as f64).exp()
    })
}

/// Reports the row of a level; the mean of scenes has times over those of the first level.
fn tell(dim: u8, scene: &str, level: &Level, row: Row, report: &mut Report) -> io::Result<()> {
    let names = match scene {
        MEAN => ["pairs_per_contact", "broad", "rest", "step"],
        _ => ["pairs_per_contact", "broad_ms", "rest_ms", "step_ms"],
    };
    let mut fields = vec![
        ("scene", scene.into()),
        ("dim", dim.into()),
        ("level", level.name.into()),
    ];
    fields.extend(names.into_iter().zip(row.map(Into::into)));
    report.row(&fields)
}

/// The scene of the means.
const MEAN: &str = "mean";

/// Runs a scene at these levels.
type Race = fn(SceneKind, usize, &[Level]) -> Vec<Figures>;

pub(crate) fn run(report: &mut Report) -> Result<()> {
    let mut means = Vec::new();
    for (dim, race) in [(2, dim2::race as Race), (3, dim3::race)] {
        let levels = levels(dim);
        let mut rows = Vec::new();
        for (kind, bodies) in SCENES {
            let races: Vec<_> = (0..ROUNDS).map(|_| race(kind, bodies, &levels)).collect();
            let of = |i| row(&races.iter().map(|race| race[i]).collect::<Vec<_>>());
            let of_scene: Vec<_> = (0..levels.len()).map(of).collect();
            for (level, row) in levels.iter().zip(&of_scene) {
                tell(dim, kind.name(), level, *row, report)?;
            }
            rows.push(of_scene);
        }
        let of_dim: Vec<_> = (0..levels.len()).map(|i| mean(&rows, i)).collect();
        for (level, row) in levels.iter().zip(&of_dim) {
            tell(dim, MEAN, level, *row, report)?;
        }
        let of_dim: Vec<_> = levels.into_iter().zip(of_dim).collect();
        means.push((format!("{dim}D"), of_dim));
    }
    let panels = means.iter().flat_map(|(dim, means)| {
        // Of the broad phase only that of the levels would be told.
        [("rest of the step", 2), ("whole step", 3)]
            .into_iter()
            .map(move |(what, k)| {
                let series = |name: &str, color, is_own| {
                    let shown = means
                        .iter()
                        .filter(|(level, _)| level.test.is_none() == is_own);
                    let labels = shown.clone().map(|(level, _)| level.name.to_string());
                    Series::new(name, color, shown.map(|(_, row)| (row[0], row[k])))
                        .labelled(labels)
                };
                let own = series("levels of unisize", color::RED, true)
                    .bold()
                    .unjoined();
                let sieves = series(
                    "other sets of axes; their own time does not count",
                    color::BLUE,
                    false,
                );
                let x = Axis::log("pairs held per contact");
                let y = Axis::linear("time, over that of Groups");
                Panel::new(format!("{what}, {dim}"), x, y, [own, sieves.unjoined()])
            })
    });
    Chart::new("Levels of the filter: left is precise, low is fast", panels)
        .columns(2)
        .own_ranges()
        .write_svg(Path::new(FILE))
}
