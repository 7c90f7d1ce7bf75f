//! How many bytes a collider broad phases hold, which is what dropping them frees, and whether time and memory a body stay level up to
//! millions. Events do not count, since they go into the caller's list.
//!
//! The same cubes move in every frame, spread over the whole environment. Moving them and listing them is not timed.

use crate::Options;
use crate::{dim2, dim2_036, dim3, dim3_036};
use unisize_report::Report;

/// Which colliders are listed, and how they have moved.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Motion {
    /// One collider in this many drifts on, and only those are listed.
    OneIn(usize),
    /// All are listed, and none has left the margin around its box.
    InMargin,
}

impl Motion {
    pub(crate) fn name(self) -> String {
        match self {
            Self::OneIn(1) => "all move".to_owned(),
            Self::OneIn(stride) => format!("one in {stride} moves"),
            Self::InMargin => "all in their margin".to_owned(),
        }
    }

    /// The distance, in indices, from one listed collider to the next.
    pub(crate) fn stride(self) -> usize {
        match self {
            Self::OneIn(stride) => stride,
            Self::InMargin => 1,
        }
    }
}

/// Cubes of side 1 and their motion. Equal cases make equal frames.
#[derive(Clone, Copy)]
pub(crate) struct Case {
    pub(crate) count: usize,
    /// The part of the area or volume that they would fill if they did not overlap.
    pub(crate) density: f64,
    pub(crate) motion: Motion,
    /// Whether each is on a dynamic body, or has none.
    pub(crate) bodies: bool,
}

/// In two and in three dimensions: gives 0.8 overlapping pairs per box.
const DENSITIES: [f64; 2] = [0.4, 0.2];

/// Numbers of bodies. The largest world takes some 10 GB.
const SCALE: [usize; 4] = [100_000, 300_000, 1_000_000, 4_000_000];

const MOTIONS: [Motion; 4] = [
    Motion::OneIn(1),
    Motion::OneIn(10),
    Motion::OneIn(100),
    Motion::InMargin,
];

/// The same in two and in three dimensions.
fn cases(count: usize, motion: Motion, bodies: bool) -> [Case; 2] {
    DENSITIES.map(|density| Case {
        count,
        density,
        motion,
        bodies,
    })
}

/// Measures the memory of both versions after each motion of colliders without bodies.
pub(crate) fn memory(options: &Options, report: &mut Report) -> anyhow::Result<()> {
    let (count, frames) = options.least((1 << 16, 60), (1_000, 3));
    for motion in MOTIONS {
        let [flat, solid] = cases(count, motion, false);
        report.row(&dim2::follow::measure(&flat, frames))?;
        report.row(&dim3::follow::measure(&solid, frames))?;
        report.row(&dim2_036::follow::measure(&flat, frames))?;
        report.row(&dim3_036::follow::measure(&solid, frames))?;
    }
    Ok(())
}

/// Does the time a body stay level? All move, on a body each.
pub(crate) fn scale(options: &Options, report: &mut Report) -> anyhow::Result<()> {
    let frames = options.least(20, 2);
    for &count in options.least(&SCALE[..], &[1_000]) {
        let [flat, solid] = cases(count, Motion::OneIn(1), true);
        report.row(&dim2::follow::measure(&flat, frames))?;
        report.row(&dim3::follow::measure(&solid, frames))?;
    }
    Ok(())
}
