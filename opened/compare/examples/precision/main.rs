//! How many pairs are left, by the axes along which the intervals of two shapes must meet.
//!
//! ```text
//! cargo run --release --package compare-opened --example precision
//! ```
//!
//! Each scene is stepped on Rapier's own broad phase. In the second half of the run it is asked, of each pair that its narrow
//! phase holds, whether the shapes' intervals, loosened by half the prediction distance, meet along all axes of a set. What no
//! test leaves out, its narrow phase has to look at in every step. Prints a Markdown table of what is left of 100 pairs.
//!
//! With `--levels` it times whole steps instead, on unisize with each level of its filter, and with each set of axes: see `levels`.

#[path = "../../../../benches/common/json_lines.rs"]
mod json_lines;
mod levels;
#[path = "../../../../benches/common/report.rs"]
mod report;
mod volume;

use clap::Parser;
use report::Report;
use std::path::PathBuf;
use unisize_scenes::SceneKind;

/// The scenes, and about how many bodies each has.
const SCENES: [(SceneKind, usize); 14] = [
    (SceneKind::FallingBalls, 2000),
    (SceneKind::Gas, 4000),
    (SceneKind::Net, 1000),
    (SceneKind::Hopper, 1000),
    (SceneKind::Ropes, 1000),
    (SceneKind::Chains, 2000),
    (SceneKind::Pyramids, 1000),
    (SceneKind::Stacks, 1000),
    (SceneKind::MixedOneAndAHalf, 2000),
    (SceneKind::MixedFour, 1000),
    (SceneKind::Bullets, 500),
    (SceneKind::Churn, 1000),
    (SceneKind::Shapes, 1000),
    (SceneKind::Soft, 500),
];

const STEPS: usize = 150;

/// What is counted: pairs with a contact, and pairs that a test does not tell apart.
#[derive(Default)]
struct Counts {
    contacts: usize,
    pairs: [usize; TESTS.len()],
}

/// What tells two shapes apart: intervals along some axes, or more.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Test {
    Margins,
    Boxes,
    Balls,
    Corners,
    Edges,
    Both,
    Centres,
    OwnAxes,
    Points,
    Distance,
}

/// In the order in which [`Counts`] has them.
const TESTS: [Test; 9] = [
    Test::Margins,
    Test::Boxes,
    Test::Corners,
    Test::Edges,
    Test::Both,
    Test::Centres,
    Test::OwnAxes,
    Test::Points,
    Test::Distance,
];

impl Test {
    fn name(self) -> &'static str {
        match self {
            Self::Margins => "with margins",
            Self::Boxes => "boxes",
            Self::Balls => "bounding balls",
            Self::Corners => "corners",
            Self::Edges => "edges",
            Self::Both => "both",
            Self::Centres => "centres",
            Self::OwnAxes => "own axes",
            Self::Points => "own axes, nearest points",
            Self::Distance => "distance",
        }
    }
}

#[path = "."]
mod dim2 {
    use unisize::rapier2d_036 as ours;
    use unisize_scenes::dim2_036 as scenes;

    mod dimension;
    mod race;
    mod sieve;
    pub(super) use dimension::count;
    pub(super) use race::race;
}

#[path = "."]
mod dim3 {
    use unisize::rapier3d_036 as ours;
    use unisize_scenes::dim3_036 as scenes;

    mod dimension;
    mod race;
    mod sieve;
    pub(super) use dimension::count;
    pub(super) use race::race;
}

/// Counts the pairs that sets of axes leave.
#[derive(Parser)]
struct Options {
    /// Time whole steps at each level of the filter and with each set of axes instead
    #[arg(long)]
    levels: bool,
    /// Append the results to this file, a JSON object a line
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

fn main() -> anyhow::Result<()> {
    let options = Options::parse();
    let mut report = Report::new(options.json.as_deref())?;
    if options.levels {
        return levels::run(&mut report);
    }
    for (dim, count) in [
        (2, dim2::count as fn(SceneKind, usize) -> Counts),
        (3, dim3::count),
    ] {
        for (kind, bodies) in SCENES {
            let Counts { contacts, pairs } = count(kind, bodies);
            let share = |count: usize| (100.0 * count as f64 / pairs[0] as f64).into();
            let mut row = vec![("dim", dim.into()), ("scene", kind.name().into())];
            row.extend(
                TESTS
                    .iter()
                    .zip(pairs)
                    .map(|(test, left)| (test.name(), share(left))),
            );
            row.push(("contact", share(contacts)));
            report.row(&row)?;
        }
    }
    Ok(())
}
