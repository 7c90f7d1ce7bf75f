//! How many bytes per collider broad phases hold, and whether time and memory per body stay level up to millions. What dropping a broad
//! phase frees is what it holds.

use crate::Options;
use crate::{dim2, dim2_036, dim3, dim3_036};
use std::time::Duration;
use unisize_report::Report;
use unisize_scenes::HardMotion;

/// Cubes of side 1 and their motion. Equal cases make equal frames.
#[derive(Clone, Copy)]
pub(crate) struct Case {
    pub(crate) motion: HardMotion,
    pub(crate) count: usize,
    /// The number of updates before those that are timed: trees go on being mended for some after the first one.
    pub(crate) settling: u32,
    /// The number of updates that are timed, unless they take longer than this.
    pub(crate) frames: u32,
    pub(crate) longest: Duration,
    /// Whether each cube is on a dynamic body, or has none.
    pub(crate) on_bodies: bool,
}

/// The motions after which memory is measured.
const MOTIONS: [HardMotion; 4] = [
    HardMotion::Drifting,
    HardMotion::HalfAsleep,
    HardMotion::Churn,
    HardMotion::Alternating,
];

/// Numbers of colliders whose memory is measured: how much room lists have to spare depends on how far a number is from a power of two.
const COUNTS: [usize; 3] = [50_000, 1 << 16, 90_000];

/// Numbers of bodies. The largest world takes some 10 GB.
const SCALE: [usize; 4] = [100_000, 300_000, 1_000_000, 4_000_000];

/// Measures the memory of both versions after each motion of colliders without bodies.
pub(crate) fn memory(options: &Options, report: &mut Report) -> anyhow::Result<()> {
    let (counts, frames) = options.least((&COUNTS[..], 60), (&[1_000], 3));
    let cases = MOTIONS
        .iter()
        .flat_map(|motion| counts.iter().map(move |count| (*motion, *count)));
    for (motion, count) in cases {
        let case = Case {
            motion,
            count,
            settling: 20,
            frames,
            longest: Duration::MAX,
            on_bodies: false,
        };
        report.row(&dim2::hard_motions::compare(&case))?;
        report.row(&dim3::hard_motions::compare(&case))?;
        report.row(&dim2_036::hard_motions::compare(&case))?;
        report.row(&dim3_036::hard_motions::compare(&case))?;
    }
    Ok(())
}

/// Measures whether the time per body stays level. All bodies move.
pub(crate) fn scale(options: &Options, report: &mut Report) -> anyhow::Result<()> {
    for &count in options.least(&SCALE[..], &[1_000]) {
        let case = Case {
            motion: HardMotion::Drifting,
            count,
            settling: 20,
            frames: options.least(20, 2),
            longest: Duration::MAX,
            on_bodies: true,
        };
        report.row(&dim2::hard_motions::compare(&case))?;
        report.row(&dim3::hard_motions::compare(&case))?;
    }
    Ok(())
}
