//! Boxes on which methods break down: how time grows, for this repository's kernels, for Parry's tree and for brute force.
//!
//! *Work* is the number of boxes and pairs together, the least that any method has to process.

use crate::Options;
use crate::growth::{self, Figures};
use std::cell::Cell;
use std::io;
use std::panic;
use std::time::{Duration, Instant};
use unisize::{Aabb, BruteForce, GridSweep, PairFinder, RankSweep};
use unisize_report::Report;
use unisize_scenes::{HardBoxes, Mixture, Needles};

/// Numbers of boxes.
const COUNTS: [usize; 4] = [1 << 12, 1 << 14, 1 << 16, 1 << 18];

/// A run that took longer is not followed by one four times as large.
const LONG: Duration = Duration::from_secs(1);

/// How many runs the median is taken of, and for how long they go on at least.
const RUNS: usize = 5;
const ENOUGH: Duration = Duration::from_millis(200);

/// A builder of Parry's tree that takes so many times as long as the other one is not tried on more boxes.
const HOPELESS: f64 = 3.0;

/// A mixture, or needles, with more pairs than this for each box are hard for any method, and are left out.
const MOST_PAIRS: usize = 64;

/// A number of boxes of an arrangement, unless they would have too many pairs.
type Draw<'a, const D: usize> = dyn Fn(usize) -> Option<Vec<[[f32; D]; 2]>> + 'a;

/// Searches these boxes with one method, for this time at least.
type Run<'a, const D: usize> = dyn Fn(&[[[f32; D]; 2]], Duration) -> Figures + 'a;

/// Measures in one dimension, of which `B` and `P` are Parry's tree, built in either way.
pub(crate) fn measure<const D: usize, B, P>(
    options: &Options,
    report: &mut Report,
) -> io::Result<()>
where
    B: PairFinder<f32, D> + Default,
    P: PairFinder<f32, D> + Default,
{
    let counts = options.least(&COUNTS[..], &[1 << 8]);
    let enough = options.least(ENOUGH, Duration::ZERO);
    let mut grow = |boxes: &str, draw: &Draw<D>| {
        let mut grow = |method: &str, run: &Run<D>| {
            let case = [
                ("dim", D.into()),
                ("boxes", boxes.into()),
                ("method", method.into()),
            ];
            growth::measure(&case, counts, |n| Some(run(&draw(n)?, enough)), report)
        };
        grow("GridSweep", &run::<GridSweep<f32, D>, D>)?;
        grow("RankSweep", &run::<RankSweep<f32, D>, D>)?;
        let is_hopeless = Cell::new(false);
        grow("Parry Bvh", &|boxes, enough| {
            let binned = run::<B, D>(boxes, enough);
            if is_hopeless.get() {
                return binned;
            }
            // PLOC panics where volumes overflow, and becomes quadratic where many are equal.
            let ploc = panic::catch_unwind(|| run::<P, D>(boxes, enough)).ok();
            let times = ploc.as_ref().map(|ploc| ploc.seconds / binned.seconds);
            is_hopeless.set(times.is_none_or(|times| times > HOPELESS));
            ploc.filter(|_| times < Some(1.0)).unwrap_or(binned)
        })?;
        grow("BruteForce", &run::<BruteForce, D>)
    };
    for kind in HardBoxes::ALL {
        grow(kind.name(), &|n| {
            (!kind.are_too_many(n)).then(|| kind.boxes(n, 7))
        })?;
    }
    let has_few_pairs = |boxes: &Vec<_>| {
        let work = run::<GridSweep<f32, D>, D>(boxes, Duration::ZERO).work;
        work <= ((MOST_PAIRS + 1) * boxes.len()) as f64
    };
    for (i, mixture) in Mixture::WORST.iter().enumerate() {
        let name = format!("mixture {}", i + 1);
        grow(&name, &|n| Some(mixture.boxes(n, 7)).filter(has_few_pairs))?;
    }
    for (i, needles) in Needles::WORST.iter().enumerate() {
        let name = format!("blocks of needles {}", i + 1);
        // The more needles, the more pairs each has.
        if has_few_pairs(&needles.boxes(counts[0], 7)) {
            grow(&name, &|n| Some(needles.boxes(n, 7)))?;
        }
    }
    Ok(())
}

fn run<K: PairFinder<f32, D> + Default, const D: usize>(
    boxes: &[[[f32; D]; 2]],
    enough: Duration,
) -> Figures {
    let count = boxes.len();
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
    Figures {
        count,
        work: (count + pairs.len()) as f64,
        seconds: time.as_secs_f64(),
        is_long: time > LONG,
        others: vec![
            ("pairs", pairs.len().into()),
            ("ms", (time.as_secs_f64() * 1e3).into()),
        ],
    }
}
