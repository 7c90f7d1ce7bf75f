//! How many bytes a collider broad phases hold, which is what dropping them frees, and whether time and memory a body stay level up to
//! millions. Events do not count, since they go into the caller's list.
//!
//! The same cubes move in every frame, spread over the whole environment. Moving them and listing them is not timed.

use crate::case::{Case, Motion};
use crate::options::Options;
use crate::report::Report;
use crate::{dim2, dim2_036, dim3, dim3_036, median, ns_each};
use std::time::Instant;
use unisize::{Aabb, GridSweep, PairFinder};
use unisize_scenes::DriftingBoxes;

/// Gives 0.8 overlapping pairs per box.
const DENSITIES: [f64; 2] = [0.4, 0.2];

/// Numbers of bodies. The largest world takes some 10 GB.
const SCALE: [usize; 4] = [100_000, 300_000, 1_000_000, 4_000_000];

const MOTIONS: [Motion; 4] = [
    Motion::OneIn(1),
    Motion::OneIn(10),
    Motion::OneIn(100),
    Motion::InMargin,
];

fn case(dim: usize, count: usize, motion: Motion, bodies: bool) -> Case {
    Case {
        count,
        density: DENSITIES[dim - 2],
        motion,
        bodies,
    }
}

/// Measures the memory of both versions after each motion of colliders without bodies.
pub(crate) fn memory(options: &Options, report: &mut Report) -> anyhow::Result<()> {
    let (count, frames) = options.least((1 << 16, 60), (1_000, 3));
    for motion in MOTIONS {
        let [flat, solid] = [2, 3].map(|dim| case(dim, count, motion, false));
        report.row(&dim2::follow::measure(&flat, frames))?;
        report.row(&dim3::follow::measure(&solid, frames))?;
        report.row(&dim2_036::follow::measure(&flat, frames))?;
        report.row(&dim3_036::follow::measure(&solid, frames))?;
    }
    Ok(())
}

/// Does the time a body stay level? All move, on a body each; the kernel gets bare boxes.
pub(crate) fn scale(options: &Options, report: &mut Report) -> anyhow::Result<()> {
    let frames = options.least(20, 2);
    for &count in options.least(&SCALE[..], &[1_000]) {
        for dim in [2, 3] {
            let case = case(dim, count, Motion::OneIn(1), true);
            let (mut row, kernel) = match dim {
                2 => (
                    dim2::follow::measure(&case, frames),
                    kernel_ns::<2>(&case, frames),
                ),
                _ => (
                    dim3::follow::measure(&case, frames),
                    kernel_ns::<3>(&case, frames),
                ),
            };
            row.push(("kernel_ns", kernel.into()));
            report.row(&row)?;
        }
    }
    Ok(())
}

/// What `GridSweep` takes for a box: the median of some frames.
fn kernel_ns<const D: usize>(case: &Case, frames: usize) -> f64 {
    let mut drifting = DriftingBoxes::<D>::new(case.count, case.density, 7);
    let (mut finder, mut pairs) = (GridSweep::<f32, D>::default(), Vec::new());
    let times = (0..frames).map(|_| {
        drifting.advance();
        let unit_box =
            |mins: &[f32; D]| Aabb::new(*mins, mins.map(|x| x + DriftingBoxes::<D>::SIZE));
        let boxes: Vec<_> = drifting.mins().iter().map(unit_box).collect();
        let start = Instant::now();
        let found = finder.find_pairs(&boxes, &mut pairs);
        let time = start.elapsed();
        assert_eq!(found, Ok(()));
        time
    });
    ns_each(median(times), case.count)
}
