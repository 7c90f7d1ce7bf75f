//! The second open question: why the time per collision grows with the number of boxes. Cachegrind counts cache misses on a
//! simulation of the paper's processor.

use crate::page::Page;
use crate::progress::progress_bar;
use crate::race::unit_boxes;
use crate::table::{Table, count, digits};
use anyhow::{Context, Result, bail, ensure};
use clap::ValueEnum;
use std::hint::black_box;
use std::process::Command;
use unisize::{Aabb, GridSweep, PairFinder, RankSweep};
use unisize_charts::{Axis, Chart, Panel, Series, color};
use unisize_scenes::DriftingBoxes;

const COUNTS: [usize; 7] = [
    1 << 14,
    1 << 15,
    1 << 16,
    1 << 17,
    1 << 18,
    1 << 19,
    1 << 20,
];
const DENSITIES: [f64; 2] = [0.2, 0.8];

/// Frames over which misses are counted; the first, in fresh memory, is one of them.
const FRAMES: usize = 3;

const QUICK_COUNTS: [usize; 1] = [1 << 10];

/// The first-level and the last-level cache of an i7-4810MQ: bytes, ways, and bytes per line.
const FIRST_LEVEL: &str = "32768,8,64";
const LAST_LEVEL: &str = "6291456,12,64";

/// The code whose misses are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Probed {
    /// The pairing phase of RankSweep.
    RankSweep,
    /// All of GridSweep.
    GridSweep,
}

impl Probed {
    const ALL: [Self; 2] = [Self::RankSweep, Self::GridSweep];

    fn name(self) -> &'static str {
        match self {
            Self::RankSweep => "rank-sweep",
            Self::GridSweep => "grid-sweep",
        }
    }

    /// Whether the function with this symbol name belongs to it.
    fn includes(self, function: &str) -> bool {
        match self {
            Self::RankSweep => {
                function.contains("rank_sweep") && function.contains("5sweep17h")
                    || function.contains("rank_sweep::Sweep::sweep")
            }
            Self::GridSweep => function.contains("grid_sweep"),
        }
    }
}

/// The counts of cachegrind; in the end, per frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Misses {
    /// Reads and writes of data that the first-level cache did not hold.
    first: f64,
    /// Those of them that the last-level cache did not hold either.
    last: f64,
}

pub(crate) fn run(page: &Page, quick: bool) -> Result<()> {
    if Command::new("valgrind").arg("--version").output().is_err() {
        println!("cache: left out, valgrind is not installed");
        return Ok(());
    }
    let counts = if quick { &QUICK_COUNTS[..] } else { &COUNTS };
    let bar = progress_bar((DENSITIES.len() * counts.len() * 2) as u64);
    bar.set_message("cachegrind");
    let mut table = Table::new([
        "d",
        "n",
        "pairs",
        "pairing: first-level misses a box",
        "pairing: last-level misses a box",
        "pairing: last-level misses a collision",
        "GridSweep: first-level misses a box",
        "GridSweep: last-level misses a box",
        "GridSweep: last-level misses a collision",
    ]);
    let mut lines = Vec::new();
    let colors = [[color::SKY, color::BLUE], [color::SALMON, color::RED]];
    let mut points = [const { [const { Vec::new() }; 2] }; 2];
    for (density, points) in DENSITIES.into_iter().zip(&mut points) {
        for &n in counts {
            let pairs = pairs(n, density)? as f64;
            let mut row = vec![density.to_string(), count(n), pairs.to_string()];
            for (probed, points) in Probed::ALL.into_iter().zip(points.iter_mut()) {
                let misses = misses(page, probed, n, density)?;
                let boxes = n as f64;
                let figures = [
                    misses.first / boxes,
                    misses.last / boxes,
                    misses.last / pairs,
                ];
                row.extend(figures.map(digits));
                points.push((boxes, misses.last / pairs));
                bar.inc(1);
            }
            table.push(row);
        }
    }
    bar.finish_and_clear();
    for (which, name) in ["pairing phase", "GridSweep, all"].iter().enumerate() {
        for (i, density) in DENSITIES.iter().enumerate() {
            let name = format!("{name}, d = {density}");
            let points = points[i][which].iter().copied();
            lines.push(Series::new(name, colors[which][i], points));
        }
    }
    let misses = Axis::linear("last-level misses per collision");
    let panel = Panel::new("", Axis::log("n"), misses, lines);
    Chart::new("Cache misses, as simulated", [panel]).write_svg(&page.picture("cache.svg"))?;
    page.put("cache", &table)
}

/// The program that runs under cachegrind.
pub(crate) fn probe(method: Probed, count: usize, density: f64) -> Result<()> {
    match method {
        Probed::RankSweep => follow(&mut RankSweep::default(), count, density),
        Probed::GridSweep => follow(&mut GridSweep::default(), count, density),
    }
}

/// Finds the pairs of every frame.
fn follow(kernel: &mut impl PairFinder<f32, 2>, count: usize, density: f64) -> Result<()> {
    let mut drifting = DriftingBoxes::<2>::new(count, density, 7);
    let (mut boxes, mut pairs) = (Vec::new(), Vec::new());
    for _ in 0..FRAMES {
        unit_boxes(drifting.mins(), &mut boxes);
        kernel.find_pairs(&boxes, &mut pairs)?;
        black_box(&pairs);
        drifting.advance();
    }
    Ok(())
}

fn boxes(count: usize, density: f64) -> Vec<Aabb<f32, 2>> {
    let mut boxes = Vec::new();
    unit_boxes(
        DriftingBoxes::<2>::new(count, density, 7).mins(),
        &mut boxes,
    );
    boxes
}

fn pairs(count: usize, density: f64) -> Result<usize> {
    let mut pairs = Vec::new();
    GridSweep::default().find_pairs(&boxes(count, density), &mut pairs)?;
    Ok(pairs.len())
}

/// Runs this program under cachegrind.
fn misses(page: &Page, probed: Probed, n: usize, density: f64) -> Result<Misses> {
    let counts = page.picture("cachegrind.out");
    let program = std::env::current_exe().context("this program has no path")?;
    let output = Command::new("valgrind")
        .args(["--tool=cachegrind", "--cache-sim=yes"])
        .arg(format!("--D1={FIRST_LEVEL}"))
        .arg(format!("--LL={LAST_LEVEL}"))
        .arg(format!("--cachegrind-out-file={}", counts.display()))
        .arg(program)
        .args(["cache-probe", probed.name()])
        .args([n.to_string(), density.to_string()])
        .env("RAYON_NUM_THREADS", "1")
        .output()
        .context("cannot run valgrind")?;
    if !output.status.success() {
        bail!("valgrind: {}", String::from_utf8_lossy(&output.stderr));
    }
    let text = std::fs::read_to_string(&counts).context("cachegrind wrote nothing")?;
    std::fs::remove_file(&counts).context("cannot remove what cachegrind wrote")?;
    let misses = read(&text, |function| probed.includes(function))?;
    Ok(Misses {
        first: misses.first / FRAMES as f64,
        last: misses.last / FRAMES as f64,
    })
}

/// Sums the counts of the included functions in a file written by cachegrind.
fn read(text: &str, includes: impl Fn(&str) -> bool) -> Result<Misses> {
    let events = text.lines().find_map(|line| line.strip_prefix("events: "));
    let events: Vec<_> = events.context("no events")?.split_whitespace().collect();
    let column = |name: &str| {
        let position = events.iter().position(|&event| event == name);
        position.with_context(|| format!("no {name}"))
    };
    let first = [column("D1mr")?, column("D1mw")?];
    let last = [column("DLmr")?, column("DLmw")?];
    let mut misses = Misses::default();
    let mut is_included = false;
    let mut functions = 0;
    for line in text.lines() {
        if let Some(function) = line.strip_prefix("fn=") {
            is_included = includes(function);
            functions += usize::from(is_included);
        } else if is_included && line.starts_with(|c: char| c.is_ascii_digit()) {
            // The number of a source line, then its counts.
            let counts: Vec<_> = line.split_whitespace().skip(1).collect();
            let sum = |columns: [usize; 2]| {
                let count = |i: usize| counts.get(i)?.parse::<f64>().ok();
                columns.into_iter().filter_map(count).sum::<f64>()
            };
            misses.first += sum(first);
            misses.last += sum(last);
        }
    }
    ensure!(functions > 0, "no function of the kernel was counted");
    Ok(misses)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_functions_that_are_included_count() {
        let text = "events: Ir I1mr ILmr Dr D1mr DLmr Dw D1mw DLmw\n\
            fl=a\nfn=x::sweep\n0 9 9 9 9 1 2 9 10 20\n3 9 9 9 9 100 0 9 0 0\n\
            fn=other\n0 9 9 9 9 1 2 9 10 20\nsummary: 1 2\n";
        let misses = read(text, |function| function.contains("sweep")).unwrap();
        let expected = Misses {
            first: 111.0,
            last: 22.0,
        };
        assert_eq!(misses, expected);
        assert!(read(text, |function| function == "none").is_err());
    }
}
