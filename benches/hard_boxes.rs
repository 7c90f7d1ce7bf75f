//! Boxes on which some methods break down: how time and memory grow, for each kernel and for a bounding volume hierarchy.
//!
//! ```text
//! cargo bench --features rapier2d-027,rapier3d-027,parallel --bench hard_boxes
//! ```
//!
//! Prints a Markdown table for each dimension. *Times uniform* is the time per box or pair, relative to uniform boxes.
//! The *slopes* are those of log time and log memory over the log of the number of boxes and pairs: 1 where they grow in
//! proportion, 2 where they grow with the square. A method that took more than a second is not tried on four times as
//! many boxes.

mod common;
#[path = "hard_boxes/hierarchy.rs"]
mod hierarchy;

use hierarchy::{Hierarchy2, Hierarchy3};
use stats_alloc::{INSTRUMENTED_SYSTEM, StatsAlloc};
use std::alloc::System;
use std::time::{Duration, Instant};
use unisize::{Aabb, BruteForce, GridSweep, PairFinder, RankSweep};
use unisize_scenes::HardBoxes;

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// Numbers of boxes.
const COUNTS: [usize; 4] = [1 << 12, 1 << 14, 1 << 16, 1 << 18];

/// The number of boxes in a smoke test.
const SMALL_COUNT: usize = 1 << 8;

/// A run that took longer is not followed by one four times as large.
const LONG: Duration = Duration::from_secs(1);

/// How many runs the median is taken of, and for how long they go on at least.
const RUNS: usize = 5;
const ENOUGH: Duration = Duration::from_millis(200);

fn main() {
    common::set_threads();
    in_dimension::<2, Hierarchy2>();
    in_dimension::<3, Hierarchy3>();
}

/// Prints the table of one dimension.
fn in_dimension<const D: usize, H: PairFinder<f32, D> + Default>() {
    println!("### {D}D, f32\n");
    println!(
        "| boxes | method | n | pairs | ms | ns for each box and pair | times uniform | slope of time | bytes a box | slope of memory |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    let mut uniform = [None; 4];
    for kind in HardBoxes::ALL {
        let [grid, rank, tree, brute] = &mut uniform;
        print::<GridSweep<f32, D>, D>(kind, "GridSweep", grid);
        print::<RankSweep<f32, D>, D>(kind, "RankSweep", rank);
        print::<H, D>(kind, "Parry Bvh", tree);
        print::<BruteForce, D>(kind, "BruteForce", brute);
    }
    println!();
}

/// One method on one kind of boxes.
struct Figures {
    count: usize,
    /// Boxes and pairs.
    work: f64,
    pairs: usize,
    seconds: f64,
    bytes: f64,
}

/// Prints a line for the largest number of boxes that was tried.
fn print<K: PairFinder<f32, D> + Default, const D: usize>(
    kind: HardBoxes,
    method: &str,
    uniform: &mut Option<f64>,
) {
    let counts = if common::is_smoke_test() {
        &[SMALL_COUNT][..]
    } else {
        &COUNTS
    };
    let mut figures: Vec<Figures> = Vec::new();
    for &count in counts {
        let is_long = figures
            .last()
            .is_some_and(|f| f.seconds > LONG.as_secs_f64());
        if !is_long && !kind.are_too_many(count) {
            figures.push(measure::<K, D>(kind, count));
        }
    }
    let Some(last) = figures.last() else { return };
    let each = last.seconds / last.work * 1e9;
    let uniform = *uniform.get_or_insert(each);
    let slope = |of: fn(&Figures) -> f64| match &figures[..] {
        [.., before, last] => {
            let slope = (of(last) / of(before)).ln() / (last.work / before.work).ln();
            format!("{slope:.2}")
        }
        _ => "–".to_owned(),
    };
    println!(
        "| {} | {method} | {} | {} | {:.2} | {each:.1} | {:.1} | {} | {:.0} | {} |",
        kind.name(),
        last.count,
        last.pairs,
        last.seconds * 1e3,
        each / uniform,
        slope(|figures| figures.seconds),
        last.bytes / last.count as f64,
        slope(|figures| figures.bytes.max(1.0)),
    );
}

fn measure<K: PairFinder<f32, D> + Default, const D: usize>(
    kind: HardBoxes,
    count: usize,
) -> Figures {
    let boxes = kind.boxes(count, 7);
    let boxes: Vec<Aabb<f32, D>> = boxes.iter().map(|&[a, b]| Aabb::new(a, b)).collect();
    let mut finder = K::default();
    let mut pairs = Vec::new();
    let mut times = Vec::new();
    let begin = Instant::now();
    while times.len() < RUNS || (begin.elapsed() < ENOUGH && !common::is_smoke_test()) {
        let start = Instant::now();
        let found = finder.find_pairs(&boxes, &mut pairs);
        times.push(start.elapsed());
        assert_eq!(found, Ok(()));
        if times[0] > LONG {
            break;
        }
    }
    times.sort_unstable();
    let before = ALLOCATOR.stats();
    drop(finder);
    let freed = ALLOCATOR.stats() - before;
    Figures {
        count,
        work: (count + pairs.len()) as f64,
        pairs: pairs.len(),
        seconds: times[times.len() / 2].as_secs_f64(),
        bytes: freed.bytes_deallocated as f64,
    }
}
