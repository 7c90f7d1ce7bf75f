//! Figure 3: the time of the pairing phase for each collision.

use crate::published::{LINES, Line};
use crate::race::{Times, drift};
use crate::run::Run;
use crate::table1::row;
use anyhow::Result;
use unisize::{PairFinder, RankSweep};
use unisize_scenes::DriftingBoxes;

/// Frames of which the median is taken.
const FRAMES: usize = 9;

pub(crate) fn measure(run: &mut Run) -> Result<()> {
    LINES.iter().try_for_each(|line| measure_line(run, line))
}

fn measure_line(run: &mut Run, line: &Line) -> Result<()> {
    let &(density, size, [_, _, theirs], [their_collisions, their_pairing]) = line;
    let n = run.squares(size);
    let frames = run.choose(3, FRAMES);
    let mut drifting = DriftingBoxes::<2>::new(n, density, 7);
    let mut rank_sweep = RankSweep::<f32, 2>::default();
    let (mut boxes, mut pairs) = (Vec::new(), Vec::new());
    let [mut pairing, mut all] = [const { Times(Vec::new()) }; 2];
    let mut collisions = 0;
    for _ in 0..frames {
        drift(&mut drifting, &mut boxes);
        rank_sweep.find_pairs(&boxes, &mut pairs)?;
        let [sorted, swept] = rank_sweep.phase_times();
        pairing.push(swept);
        all.push(sorted + swept);
        collisions += pairs.len();
    }
    let collisions = collisions as f64 / frames as f64;
    let each = |ms: f64, collisions: f64| ms * 1e6 / collisions;
    let columns = [
        ("density", density.into()),
        ("n", n.into()),
        ("their_thousands", their_collisions.into()),
        ("thousands", (collisions / 1e3).into()),
        ("their_pairing_ms", their_pairing.into()),
        ("pairing_ms", pairing.median().into()),
        ("their_share", (their_pairing / theirs).into()),
        ("share", (pairing.median() / all.median()).into()),
        (
            "their_ns",
            each(their_pairing, their_collisions * 1e3).into(),
        ),
        ("rank_sweep_ns", each(pairing.median(), collisions).into()),
    ];
    Ok(run.row("figure3", &row(density, n), &columns)?)
}
