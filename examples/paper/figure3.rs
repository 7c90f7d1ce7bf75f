//! Figure 3: the time that the pairing phase takes for each collision.

use crate::page::Page;
use crate::progress::progress_bar;
use crate::published::{self, LINES};
use crate::race::unit_boxes;
use crate::table::{Table, count, digits};
use anyhow::{Context, Result};
use unisize::{GridSweep, PairFinder, RankSweep};
use unisize_charts::{Axis, Chart, Panel, RGBColor, Series, color};
use unisize_scenes::DriftingBoxes;

/// Frames of which the median is taken.
const FRAMES: usize = 9;

const QUICK_COUNT: usize = 1 << 10;
const QUICK_FRAMES: usize = 3;

/// A colour for each density, the lowest first.
const COLORS: [RGBColor; 4] = [color::SKY, color::BLUE, color::PURPLE, color::RED];

/// The measurements for one line of the table.
struct Measured {
    collisions: f64,
    /// Milliseconds of the pairing phase.
    pairing: f64,
    /// Milliseconds of GridSweep's sweep.
    sweep: f64,
}

pub(crate) fn run(page: &Page, quick: bool) -> Result<()> {
    let frames = if quick { QUICK_FRAMES } else { FRAMES };
    let bar = progress_bar((LINES.len() * frames) as u64);
    bar.set_message("pairing phase");
    let mut table = Table::new([
        "d",
        "n",
        "paper: C / 1000",
        "here: C / 1000",
        "paper: t_p, ms",
        "here: t_p, ms",
        "paper: t_c, ns",
        "here: t_c, ns",
        "GridSweep: sweep, ms",
        "GridSweep: ns a collision",
    ]);
    let mut lines: [Vec<Series>; 3] = Default::default();
    for (group, color) in LINES.chunk_by(|a, b| a.density == b.density).zip(COLORS) {
        let mut points: [Vec<(f64, f64)>; 3] = Default::default();
        for line in group {
            let n = if quick {
                QUICK_COUNT << (line.size - 17)
            } else {
                1 << line.size
            };
            let measured = measure(line, n, frames, || bar.inc(1))?;
            let each = |ms: f64, collisions: f64| ms * 1e6 / collisions;
            let theirs = each(line.pairing, line.collisions * 1e3);
            let ours = each(measured.pairing, measured.collisions);
            let grid = each(measured.sweep, measured.collisions);
            for (points, y) in points.iter_mut().zip([theirs, ours, grid]) {
                points.push((n as f64, y));
            }
            let figures = [
                line.collisions,
                measured.collisions / 1e3,
                line.pairing,
                measured.pairing,
                theirs,
                ours,
                measured.sweep,
                grid,
            ];
            let mut row = vec![line.density.to_string(), count(n)];
            row.extend(figures.map(digits));
            table.push(row);
        }
        let name = format!("d = {}", group[0].density);
        for (lines, points) in lines.iter_mut().zip(points) {
            lines.push(Series::new(&name, color, points));
        }
    }
    bar.finish_and_clear();
    let titles = [
        "The paper, laptop of 2014",
        "RankSweep, pairing phase",
        "GridSweep, its sweep",
    ];
    let panels = titles.into_iter().zip(lines).map(|(title, lines)| {
        let time = Axis::log("nanoseconds per collision");
        Panel::new(title, Axis::log("n"), time, lines)
    });
    Chart::new("Time per collision", panels).write_svg(&page.picture("figure3.svg"))?;
    page.put("figure3", &table)
}

fn measure(
    line: &published::Line,
    n: usize,
    frames: usize,
    on_frame: impl Fn(),
) -> Result<Measured> {
    let mut drifting = DriftingBoxes::<2>::new(n, line.density, 7);
    let mut rank_sweep = RankSweep::<f32, 2>::default().timed();
    let mut grid_sweep = GridSweep::<f32, 2>::default().timed();
    let (mut boxes, mut pairs) = (Vec::new(), Vec::new());
    let (mut pairing, mut sweep, mut collisions) = (Vec::new(), Vec::new(), 0);
    for _ in 0..frames {
        drifting.advance();
        unit_boxes(drifting.mins(), &mut boxes);
        rank_sweep
            .find_pairs(&boxes, &mut pairs)
            .context("RankSweep")?;
        pairing.push(rank_sweep.phase_times().sweep.as_secs_f64() * 1e3);
        grid_sweep
            .find_pairs(&boxes, &mut pairs)
            .context("GridSweep")?;
        sweep.push(grid_sweep.phase_times().sweep.as_secs_f64() * 1e3);
        collisions += pairs.len();
        on_frame();
    }
    let median = |times: &mut Vec<f64>| {
        times.sort_unstable_by(f64::total_cmp);
        times[times.len() / 2]
    };
    Ok(Measured {
        collisions: collisions as f64 / frames as f64,
        pairing: median(&mut pairing),
        sweep: median(&mut sweep),
    })
}
