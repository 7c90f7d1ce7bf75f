//! What more threads gain in sorting and in pairing.

use crate::Run;
use crate::race::unit_boxes;
use crate::table1::row;
use anyhow::{Result, ensure};
use std::time::Duration;
use unisize::{GridSweep, PairFinder, PhaseTimes, RankSweep};
use unisize_scenes::DriftingBoxes;

const COUNTS: [usize; 4] = [1 << 17, 1 << 18, 1 << 19, 1 << 20];
const FRAMES: usize = 9;

/// The phases, and how long each has taken.
type Phase = (&'static str, fn(&PhaseTimes) -> Duration);
const PHASES: [Phase; 3] = [
    ("sort", |times| times.sort),
    ("sweep", |times| times.sweep),
    ("all", PhaseTimes::total),
];

pub(crate) fn measure(run: &mut Run) -> Result<()> {
    for density in [0.2, 0.8] {
        for &n in run.choose(&[1 << 14][..], &COUNTS[..]) {
            let [one, many] = [0; 2].map(|_| RankSweep::<f32, 2>::default().timed());
            gains(
                run,
                [density, n as f64],
                "RankSweep",
                [one, many],
                RankSweep::phase_times,
            )?;
            let [one, many] = [0; 2].map(|_| GridSweep::<f32, 2>::default().timed());
            gains(
                run,
                [density, n as f64],
                "GridSweep",
                [one, many],
                GridSweep::phase_times,
            )?;
        }
    }
    Ok(())
}

/// The speed-up of all threads over one, phase by phase. Frames alternate between the two.
fn gains<K: PairFinder<f32, 2> + Send>(
    run: &mut Run,
    [density, n]: [f64; 2],
    name: &str,
    mut kernels: [K; 2],
    phase_times: fn(&K) -> PhaseTimes,
) -> Result<()> {
    let threads = std::thread::available_parallelism().map_or(1, |threads| threads.get());
    let pool = |threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pools = [pool(1)?, pool(threads)?];
    let mut drifting = DriftingBoxes::<2>::new(n as usize, density, 7);
    let mut boxes = Vec::new();
    let mut pairs = [const { Vec::new() }; 2];
    let mut times = [const { Vec::new() }; 2];
    for frame in 0..=run.choose(2, FRAMES) {
        drifting.advance();
        unit_boxes(drifting.mins(), &mut boxes);
        for which in [0, 1] {
            let (kernel, pairs) = (&mut kernels[which], &mut pairs[which]);
            pools[which].install(|| kernel.find_pairs(&boxes, pairs))?;
            if frame > 0 {
                times[which].push(phase_times(kernel));
            }
        }
        ensure!(
            pairs[0] == pairs[1],
            "{name}: the pairs or their order differ"
        );
    }
    for (phase, of) in PHASES {
        let [one, many] = times.each_ref().map(|times| {
            let mut times: Vec<_> = times.iter().map(of).collect();
            times.sort_unstable();
            times[times.len() / 2].as_secs_f64()
        });
        let row = row(density, n as usize);
        run.table
            .add("threads", row, format!("{name}: {phase}"), one / many);
    }
    Ok(())
}
