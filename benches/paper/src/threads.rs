//! What more threads gain.

use crate::race::{Times, drift};
use crate::run::Run;
use crate::table1::row;
use anyhow::{Result, ensure};
use std::time::Instant;
use unisize::{GridSweep, PairFinder, RankSweep};
use unisize_scenes::DriftingBoxes;

const COUNTS: [usize; 4] = [1 << 17, 1 << 18, 1 << 19, 1 << 20];
const FRAMES: usize = 9;

pub(crate) fn measure(run: &mut Run) -> Result<()> {
    for density in [0.2, 0.8] {
        for &n in run.choose(&[1 << 14][..], &COUNTS[..]) {
            let frames = run.choose(2, FRAMES);
            let boxes = DriftingBoxes::new(n, density, 7);
            let rank_sweep = gain::<RankSweep<f32, 2>>(boxes.clone(), frames)?;
            let grid_sweep = gain::<GridSweep<f32, 2>>(boxes, frames)?;
            let columns = [
                ("rank_sweep", rank_sweep.into()),
                ("grid_sweep", grid_sweep.into()),
            ];
            run.row("threads", &row(density, n), &columns)?;
        }
    }
    Ok(())
}

/// The speed-up of all threads over one. Frames alternate between the two.
fn gain<K: PairFinder<f32, 2> + Default + Send>(
    mut drifting: DriftingBoxes<2>,
    frames: usize,
) -> Result<f64> {
    let threads = std::thread::available_parallelism().map_or(1, |threads| threads.get());
    let pool = |threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pools = [pool(1)?, pool(threads)?];
    let mut kernels = [K::default(), K::default()];
    let mut boxes = Vec::new();
    let mut pairs = [const { Vec::new() }; 2];
    let mut times = [const { Times(Vec::new()) }; 2];
    for frame in 0..=frames {
        drift(&mut drifting, &mut boxes);
        for which in [0, 1] {
            let (kernel, pairs) = (&mut kernels[which], &mut pairs[which]);
            let start = Instant::now();
            pools[which].install(|| kernel.find_pairs(&boxes, pairs))?;
            if frame > 0 {
                times[which].push(start.elapsed());
            }
        }
        ensure!(pairs[0] == pairs[1], "the pairs or their order differ");
    }
    let [one, all] = times;
    Ok(one.median() / all.median())
}
