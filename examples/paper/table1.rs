//! Table 1: drifting squares at several numbers and densities, by all methods.

use crate::method;
use crate::page::Page;
use crate::progress::progress_bar;
use crate::published::LINES;
use crate::race::{race, unit_boxes};
use crate::rapier;
use crate::table::{Table, count, digits};
use anyhow::{Result, ensure};
use unisize_scenes::DriftingBoxes;

/// Frames of which the median is taken.
const FRAMES: usize = 5;

/// In a quick run, squares and frames.
const QUICK_COUNT: usize = 1 << 10;
const QUICK_FRAMES: usize = 2;

pub(crate) fn run(page: &Page, quick: bool) -> Result<()> {
    let frames = if quick { QUICK_FRAMES } else { FRAMES };
    let bar = progress_bar((LINES.len() * (frames + 1)) as u64);
    let mut times = None;
    let mut ratios = Table::new([
        "d",
        "n",
        "paper: Bar92 / theirs",
        "here: SweepAndPrune / RankSweep",
        "paper: KMZ13 / theirs",
        "here: StreamedSegmentTree / RankSweep",
        "CoherentSweepAndPrune / RankSweep",
        "DualAxisSweep / RankSweep",
        "RankSweep / GridSweep",
        "Rapier 0.27 / GridSweep",
    ]);
    for line in LINES {
        let n = if quick { QUICK_COUNT } else { 1 << line.size };
        bar.set_message(format!("d = {}, n = {}", line.density, count(n)));
        let mut drifting = DriftingBoxes::<2>::new(n, line.density, 7);
        let mut methods = method::all();
        methods.splice(0..0, rapier::hierarchies(drifting.mins()));
        let names: Vec<_> = methods.iter().map(|method| method.name()).collect();
        let next = |boxes: &mut Vec<_>| {
            drifting.advance();
            unit_boxes(drifting.mins(), boxes);
        };
        let outcome = race(&mut methods, frames, next, |_| bar.inc(1))?;
        let medians: Vec<_> = outcome.times.iter().map(|times| times.median()).collect();

        let table = times.get_or_insert_with(|| {
            let paper = ["paper: Bar92", "paper: KMZ13", "paper: theirs"];
            let head = ["d", "n", "pairs"].iter().chain(&paper).chain(&names);
            Table::new(head.copied())
        });
        let paper = [line.sweep_and_prune, line.cgal, line.rank_sweep];
        let mut row = vec![line.density.to_string(), count(n)];
        row.push(format!("{:.0}", outcome.mean_pairs()));
        row.extend(paper.iter().chain(&medians).map(|&ms| digits(ms)));
        table.push(row);

        let of = |name: &str| {
            let mut named = names
                .iter()
                .zip(&medians)
                .filter(|(other, _)| **other == name);
            named.next().map_or(f64::NAN, |(_, &median)| median)
        };
        let rank_sweep = of("RankSweep");
        let mut row = vec![line.density.to_string(), count(n)];
        row.extend(
            [
                line.sweep_and_prune / line.rank_sweep,
                of("SweepAndPrune") / rank_sweep,
                line.cgal / line.rank_sweep,
                of("StreamedSegmentTree") / rank_sweep,
                of("CoherentSweepAndPrune") / rank_sweep,
                of("DualAxisSweep") / rank_sweep,
                rank_sweep / of("GridSweep"),
                of(rapier::NAMES[0]) / of("GridSweep"),
            ]
            .map(digits),
        );
        ensure!(!row.iter().any(|cell| cell == "–"), "a method is missing");
        ratios.push(row);
    }
    bar.finish_and_clear();
    if let Some(table) = times {
        page.put("table1", &table)?;
    }
    page.put("table1-ratios", &ratios)
}
