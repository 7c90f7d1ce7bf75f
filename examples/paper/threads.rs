//! The first open question: what more threads gain in sorting and in pairing.

use crate::page::Page;
use crate::progress::progress_bar;
use crate::race::unit_boxes;
use crate::table::{Table, count, digits};
use anyhow::{Context, Result};
use std::time::Duration;
use unisize::{Aabb, GridSweep, PairFinder, PhaseTimes, RankSweep};
use unisize_scenes::DriftingBoxes;

/// The paper's average speed-up by sorting both axes at once.
const PUBLISHED: f64 = 1.25;

const COUNTS: [usize; 4] = [1 << 17, 1 << 18, 1 << 19, 1 << 20];
const DENSITIES: [f64; 2] = [0.2, 0.8];
const FRAMES: usize = 9;

const QUICK_COUNTS: [usize; 1] = [1 << 14];
const QUICK_FRAMES: usize = 2;

/// A kernel that times its phases.
trait Timed: PairFinder<f32, 2> + Send {
    fn create() -> Self;
    fn times(&self) -> PhaseTimes;
}

impl Timed for RankSweep<f32, 2> {
    fn create() -> Self {
        Self::default().timed()
    }
    fn times(&self) -> PhaseTimes {
        self.phase_times()
    }
}

impl Timed for GridSweep<f32, 2> {
    fn create() -> Self {
        Self::default().timed()
    }
    fn times(&self) -> PhaseTimes {
        self.phase_times()
    }
}

pub(crate) fn run(page: &Page, quick: bool) -> Result<()> {
    let threads = std::thread::available_parallelism().map_or(1, |threads| threads.get());
    let (counts, frames) = if quick {
        (&QUICK_COUNTS[..], QUICK_FRAMES)
    } else {
        (&COUNTS[..], FRAMES)
    };
    let bar = progress_bar((DENSITIES.len() * counts.len() * 2) as u64);
    bar.set_message("threads");
    let mut head = vec!["d".to_owned(), "n".to_owned()];
    head.push("paper: theirs".to_owned());
    for kernel in ["RankSweep", "GridSweep"] {
        head.extend(["sort", "sweep", "all"].map(|phase| format!("{kernel}: {phase}")));
    }
    let mut table = Table::new(head);
    for density in DENSITIES {
        for &n in counts {
            let mut row = vec![density.to_string(), count(n), digits(PUBLISHED)];
            row.extend(gains::<RankSweep<f32, 2>>(n, density, threads, frames)?);
            bar.inc(1);
            row.extend(gains::<GridSweep<f32, 2>>(n, density, threads, frames)?);
            bar.inc(1);
            table.push(row);
        }
    }
    bar.finish_and_clear();
    page.put("threads", &table)
}

/// The speed-up of all threads over one in sorting, in sweeping, and in total. Frames alternate between the two.
fn gains<K: Timed>(n: usize, density: f64, threads: usize, frames: usize) -> Result<[String; 3]> {
    let pool = |threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pools = [pool(1)?, pool(threads)?];
    let mut kernels = [K::create(), K::create()];
    let mut drifting = DriftingBoxes::<2>::new(n, density, 7);
    let mut boxes: Vec<Aabb<f32, 2>> = Vec::new();
    let mut pairs = [Vec::new(), Vec::new()];
    let mut times = [const { Vec::new() }; 2];
    for frame in 0..=frames {
        drifting.advance();
        unit_boxes(drifting.mins(), &mut boxes);
        for which in [0, 1] {
            let (kernel, pairs) = (&mut kernels[which], &mut pairs[which]);
            let found = pools[which].install(|| kernel.find_pairs(&boxes, pairs));
            found.context("the kernel")?;
            if frame > 0 {
                times[which].push(kernel.times());
            }
        }
        anyhow::ensure!(pairs[0] == pairs[1], "the pairs or their order differ");
    }
    let gain = |of: fn(&PhaseTimes) -> Duration| {
        let [one, many] = &times;
        digits(median(one, of) / median(many, of))
    };
    Ok([
        gain(|times| times.sort),
        gain(|times| times.sweep),
        gain(PhaseTimes::total),
    ])
}

fn median(times: &[PhaseTimes], of: fn(&PhaseTimes) -> Duration) -> f64 {
    let mut times: Vec<_> = times.iter().map(of).collect();
    times.sort_unstable();
    times[times.len() / 2].as_secs_f64()
}
