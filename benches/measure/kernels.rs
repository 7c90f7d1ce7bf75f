//! The phases of `GridSweep`, and its distance from a lower bound.
//!
//! Each phase is the median over some frames, between which the boxes drift. The *floor* is measured on the same frames: reading
//! every box once, moving every box to its strip by one counting sort (one pass over the boxes to count, one to place them), and
//! writing every pair once. The *slope* is that of log time over the log of the number of boxes, between two rows.

use crate::floor::Floor;
use crate::options::Options;
use crate::report::Report;
use crate::{median, ns_each};
use std::io;
use std::time::{Duration, Instant};
use unisize::{Aabb, GridSweep, PairFinder};
use unisize_scenes::DriftingBoxes;

/// Numbers of boxes.
const COUNTS: [usize; 6] = [1 << 10, 1 << 12, 1 << 14, 1 << 16, 1 << 18, 1 << 20];

/// The frames of a case hold about this many boxes together, but their number stays within the limits below.
const BOXES: usize = 1 << 24;
const FRAMES: [usize; 2] = [15, 501];

/// Measures in both dimensions, at two densities each.
pub(crate) fn measure(options: &Options, report: &mut Report) -> io::Result<()> {
    in_dimension::<2>([0.2, 0.8], options, report)?;
    in_dimension::<3>([0.1, 0.4], options, report)
}

fn in_dimension<const D: usize>(
    densities: [f64; 2],
    options: &Options,
    report: &mut Report,
) -> io::Result<()> {
    for density in densities {
        let mut last: Option<[f64; 2]> = None;
        for &count in options.counts(&COUNTS, 1 << 12) {
            let frames = (BOXES / count).clamp(FRAMES[0], FRAMES[1]);
            let phases = Phases::of::<D>(count, density, options.least(frames, 3));
            let this = [count as f64, phases.all.as_secs_f64()];
            let slope = last.map(|last| (this[1] / last[1]).ln() / (this[0] / last[0]).ln());
            last = Some(this);
            let us = |time: Duration| (time.as_secs_f64() * 1e6).into();
            report.row(&[
                ("threads", rayon::current_num_threads().into()),
                ("dim", D.into()),
                ("density", density.into()),
                ("count", count.into()),
                ("pairs", phases.pairs.into()),
                ("read_us", us(phases.read)),
                ("sort_us", us(phases.sort)),
                ("sweep_us", us(phases.sweep)),
                ("all_us", us(phases.all)),
                ("ns_a_box", ns_each(phases.all, count).into()),
                ("slope", slope.into()),
                ("floor_us", us(phases.floor)),
                (
                    "times_floor",
                    phases.all.div_duration_f64(phases.floor).into(),
                ),
            ])?;
        }
    }
    Ok(())
}

/// The medians over some frames.
pub(crate) struct Phases {
    pairs: usize,
    read: Duration,
    sort: Duration,
    sweep: Duration,
    pub(crate) all: Duration,
    floor: Duration,
}

impl Phases {
    /// Finds the pairs of so many drifting boxes.
    pub(crate) fn of<const D: usize>(count: usize, density: f64, frames: usize) -> Self {
        let mut drifting = DriftingBoxes::<D>::new(count, density, 7);
        let mut finder = GridSweep::<f32, D>::default().timed();
        let mut floor = Floor::default();
        let (mut boxes, mut pairs, mut times) = (Vec::new(), Vec::new(), Vec::new());
        for _ in 0..frames {
            drifting.advance();
            boxes.clear();
            boxes.extend(drifting.mins().iter().map(unit_box));
            let start = Instant::now();
            let found = finder.find_pairs(&boxes, &mut pairs);
            let all = start.elapsed();
            assert_eq!(found, Ok(()));
            let phases = finder.phase_times();
            let floor = floor.measure(&boxes, &pairs);
            times.push([phases.read, phases.sort, phases.sweep, all, floor]);
        }
        let [read, sort, sweep, all, floor] =
            std::array::from_fn(|phase| median(times.iter().map(|times| times[phase])));
        Self {
            pairs: pairs.len(),
            read,
            sort,
            sweep,
            all,
            floor,
        }
    }
}

/// The unit box at a lower corner.
pub(crate) fn unit_box<const D: usize>(mins: &[f32; D]) -> Aabb<f32, D> {
    Aabb::new(*mins, mins.map(|x| x + DriftingBoxes::<D>::SIZE))
}
