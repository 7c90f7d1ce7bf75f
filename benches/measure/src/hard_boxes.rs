//! Boxes on which methods break down: how time grows, for this repository's kernels, for Parry's tree and for brute force.
//!
//! *Work* is the number of boxes and pairs together, the least that any method has to process.

use crate::Options;
use crate::growth::{self, Figures};
use std::io;
use std::time::{Duration, Instant};
use unisize::{Aabb, BruteForce, GridSweep, PairFinder, RankSweep};
use unisize_report::Report;
use unisize_scenes::HardBoxes;

/// Numbers of boxes.
const COUNTS: [usize; 4] = [1 << 12, 1 << 14, 1 << 16, 1 << 18];

/// A run that took longer is not followed by one four times as large.
const LONG: Duration = Duration::from_secs(1);

/// How many runs the median is taken of, and for how long they go on at least.
const RUNS: usize = 5;
const ENOUGH: Duration = Duration::from_millis(200);

/// Measures in one dimension, of which `H` is Parry's tree.
pub(crate) fn measure<const D: usize, H: PairFinder<f32, D> + Default>(
    options: &Options,
    report: &mut Report,
) -> io::Result<()> {
    let counts = options.least(&COUNTS[..], &[1 << 8]);
    let enough = options.least(ENOUGH, Duration::ZERO);
    for kind in HardBoxes::ALL {
        let mut grow = |method: &str, run: fn(HardBoxes, usize, Duration) -> Option<Figures>| {
            let [boxes, method] = [kind.name(), method].map(Into::into);
            let case = [("dim", D.into()), ("boxes", boxes), ("method", method)];
            growth::measure(&case, counts, |n| run(kind, n, enough), report)
        };
        grow("GridSweep", run::<GridSweep<f32, D>, D>)?;
        grow("RankSweep", run::<RankSweep<f32, D>, D>)?;
        grow("Parry Bvh", run::<H, D>)?;
        grow("BruteForce", run::<BruteForce, D>)?;
    }
    Ok(())
}

fn run<K: PairFinder<f32, D> + Default, const D: usize>(
    kind: HardBoxes,
    count: usize,
    enough: Duration,
) -> Option<Figures> {
    if kind.are_too_many(count) {
        return None;
    }
    let boxes = kind.boxes(count, 7);
    let boxes: Vec<Aabb<f32, D>> = boxes.iter().map(|&[a, b]| Aabb::new(a, b)).collect();
    let (mut finder, mut pairs, mut times) = (K::default(), Vec::new(), Vec::new());
    let begin = Instant::now();
    while times.len() < RUNS || begin.elapsed() < enough {
        let start = Instant::now();
        let found = finder.find_pairs(&boxes, &mut pairs);
        times.push(start.elapsed());
        assert_eq!(found, Ok(()));
        if times[0] > LONG {
            break;
        }
    }
    times.sort_unstable();
    let time = times[times.len() / 2];
    Some(Figures {
        count,
        work: (count + pairs.len()) as f64,
        seconds: time.as_secs_f64(),
        is_long: time > LONG,
        others: vec![
            ("pairs", pairs.len().into()),
            ("ms", (time.as_secs_f64() * 1e3).into()),
        ],
    })
}
