//! Figure 3: the time of the pairing phase for each collision.

use crate::Run;
use crate::published::{LINES, Line};
use crate::race::{Times, drift};
use crate::table1::row;
use anyhow::Result;
use unisize::{GridSweep, PairFinder, RankSweep};
use unisize_charts::{Axis, Chart, Panel, RGBColor, Series, color};
use unisize_scenes::DriftingBoxes;

/// Frames of which the median is taken.
const FRAMES: usize = 9;

/// A colour for each density, the lowest first.
const COLORS: [RGBColor; 4] = [color::MINT, color::GREEN, color::GREY, color::BLACK];

/// The panels, with the columns that they show.
const PANELS: [(&str, &str); 3] = [
    ("The paper, laptop of 2014", "paper: t_c, ns"),
    ("RankSweep, pairing phase", "t_c, ns"),
    ("GridSweep, its sweep", "GridSweep: ns a collision"),
];

pub(crate) fn measure(run: &mut Run) -> Result<()> {
    for line in &LINES {
        measure_line(run, line)?;
    }
    let groups: Vec<_> = LINES.chunk_by(|a, b| a.0 == b.0).zip(COLORS).collect();
    let panels = PANELS.map(|(title, column)| {
        let curves = groups.iter().map(|(group, color)| {
            let points = group.iter().map(|line| {
                let n = run.squares(line.1);
                let y = run.table.number("figure3", &row(line.0, n), column);
                (n as f64, y.unwrap_or(f64::NAN))
            });
            Series::new(format!("d = {}", group[0].0), *color, points)
        });
        let time = Axis::log("nanoseconds per collision");
        Panel::new(title, Axis::log("n"), time, curves)
    });
    Chart::new("Time per collision", panels).write_svg(&run.pictures.join("figure3.svg"))
}

fn measure_line(run: &mut Run, line: &Line) -> Result<()> {
    let &(density, size, [_, _, theirs], [their_collisions, their_pairing]) = line;
    let n = run.squares(size);
    let frames = run.choose(3, FRAMES);
    let mut drifting = DriftingBoxes::<2>::new(n, density, 7);
    let mut rank_sweep = RankSweep::<f32, 2>::default().timed();
    let mut grid_sweep = GridSweep::<f32, 2>::default().timed();
    let (mut boxes, mut pairs) = (Vec::new(), Vec::new());
    let [mut pairing, mut all, mut sweep] = [const { Times(Vec::new()) }; 3];
    let mut collisions = 0;
    for _ in 0..frames {
        drift(&mut drifting, &mut boxes);
        rank_sweep.find_pairs(&boxes, &mut pairs)?;
        pairing.push(rank_sweep.phase_times().sweep);
        all.push(rank_sweep.phase_times().total());
        grid_sweep.find_pairs(&boxes, &mut pairs)?;
        sweep.push(grid_sweep.phase_times().sweep);
        collisions += pairs.len();
    }
    let collisions = collisions as f64 / frames as f64;
    let each = |ms: f64, collisions: f64| ms * 1e6 / collisions;
    let row = row(density, n);
    for (column, value) in [
        ("paper: C / 1000", their_collisions),
        ("C / 1000", collisions / 1e3),
        ("paper: t_p, ms", their_pairing),
        ("t_p, ms", pairing.median()),
        ("paper: share of t_p", their_pairing / theirs),
        ("share of t_p", pairing.median() / all.median()),
        (PANELS[0].1, each(their_pairing, their_collisions * 1e3)),
        (PANELS[1].1, each(pairing.median(), collisions)),
        (PANELS[2].1, each(sweep.median(), collisions)),
    ] {
        run.table.add("figure3", &row, column, value);
    }
    Ok(())
}
