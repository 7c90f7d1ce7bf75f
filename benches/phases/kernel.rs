//! The phases of `GridSweep`, and its distance from the floor.

use super::floor::{self, Floor};
use super::{median, microseconds};
use crate::common;
use std::time::Instant;
use unisize::{Aabb, GridSweep, PairFinder};
use unisize_scenes::DriftingBoxes;

/// Base-2 logarithms of the numbers of boxes.
const SIZES: [u32; 6] = [10, 12, 14, 16, 18, 20];

/// The largest of them in a smoke test.
const SMOKE_TEST_MAX: u32 = 12;

/// The frames of a case hold about this many boxes together, but their number stays within the limits below.
const BOXES: usize = 1 << 24;
const FRAMES: [usize; 2] = [15, 501];

/// A table for each density.
pub(super) fn print<const D: usize>(densities: [f64; 2]) {
    for density in densities {
        println!("### GridSweep, {D}D, f32, density {density}: microseconds, median\n");
        println!(
            "| n | pairs | read | sort | sweep | all | ns a box | slope | floor | times the floor |"
        );
        println!("|---|---|---|---|---|---|---|---|---|---|");
        let mut last = None;
        for size in SIZES {
            if common::is_smoke_test() && size > SMOKE_TEST_MAX {
                break;
            }
            last = Some(print_row::<D>(1 << size, density, last));
        }
        println!();
    }
}

/// The ways to sort that the floor was chosen from, on squares of the lower density.
pub(super) fn print_floors() {
    let sizes = [14, 17, 20].map(|size| {
        if common::is_smoke_test() {
            SMOKE_TEST_MAX
        } else {
            size
        }
    });
    let cases = sizes.map(|size| {
        let drifting = DriftingBoxes::<2>::new(1 << size, 0.2, 7);
        drifting.mins().iter().map(unit_box).collect()
    });
    floor::print_ways(&cases);
}

/// Prints one line, and returns the number of boxes and the seconds for the next one.
fn print_row<const D: usize>(count: usize, density: f64, last: Option<[f64; 2]>) -> [f64; 2] {
    let mut drifting = DriftingBoxes::<D>::new(count, density, 7);
    let mut finder = GridSweep::<f32, D>::default().timed();
    let mut floor = Floor::default();
    let (mut boxes, mut pairs) = (Vec::new(), Vec::new());
    let (mut phases, mut floors) = (Vec::new(), Vec::new());
    let frames = (BOXES / count).clamp(FRAMES[0], FRAMES[1]);
    for _ in 0..if common::is_smoke_test() { 3 } else { frames } {
        drifting.advance();
        boxes.clear();
        boxes.extend(drifting.mins().iter().map(unit_box));
        let start = Instant::now();
        let found = finder.find_pairs(&boxes, &mut pairs);
        let all = start.elapsed();
        assert_eq!(found, Ok(()));
        let times = finder.phase_times();
        phases.push([times.read, times.sort, times.sweep, all]);
        floors.push(floor.measure(&boxes, &pairs));
    }
    let [read, sort, sweep, all] =
        std::array::from_fn(|phase| median(phases.iter().map(|times| times[phase])));
    let floor = median(floors);
    let this = [count as f64, all.as_secs_f64()];
    let slope = last.map_or("–".to_owned(), |last| {
        let [boxes, time] = std::array::from_fn(|k| (this[k] / last[k]).ln());
        let slope: f64 = time / boxes;
        format!("{slope:.2}")
    });
    println!(
        "| {count} | {} | {} | {} | {} | {} | {:.1} | {slope} | {} | {:.1} |",
        pairs.len(),
        microseconds(read),
        microseconds(sort),
        microseconds(sweep),
        microseconds(all),
        all.as_secs_f64() * 1e9 / count as f64,
        microseconds(floor),
        all.as_secs_f64() / floor.as_secs_f64(),
    );
    this
}

fn unit_box<const D: usize>(mins: &[f32; D]) -> Aabb<f32, D> {
    Aabb::new(*mins, mins.map(|x| x + DriftingBoxes::<D>::SIZE))
}
