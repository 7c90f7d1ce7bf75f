//! One figure: a contender in a case.

use crate::report::Report;
use crate::times::Times;
use std::io;

/// What one contender took in one case. Times are in milliseconds a frame.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    /// `kernels` or `updates`.
    pub(crate) subject: &'static str,
    pub(crate) dim: usize,
    /// The part of the area or volume that the boxes would fill if they did not overlap.
    pub(crate) density: f64,
    /// What moves between two frames.
    pub(crate) motion: String,
    pub(crate) count: usize,
    pub(crate) contender: String,
    /// The setting that was best, of those that were tried.
    pub(crate) setting: String,
    pub(crate) times: Times,
    /// The pairs of the last frame.
    pub(crate) pairs: usize,
    /// Its time in that of unisize's own in this case: above 1, unisize is faster.
    pub(crate) ratio: f64,
}

impl Row {
    /// The time that counts. A kernel's frames are alike, or alike from turn to turn, so that a turn that was held
    /// up can be left out. A broad phase may do most of its work in one frame of many, which must count.
    pub(crate) fn time_ms(&self) -> f64 {
        if self.subject == "kernels" {
            self.times.typical()
        } else {
            self.times.mean()
        }
    }

    /// Whether both are of the same case but for the number of boxes.
    pub(crate) fn is_in_series_with(&self, other: &Self) -> bool {
        let case = |row: &Self| (row.subject, row.dim, row.density.to_bits());
        case(self) == case(other) && self.motion == other.motion
    }

    /// Prints the row, and writes it.
    pub(crate) fn report(&self, report: &mut Report) -> io::Result<()> {
        report.row(&[
            ("subject", self.subject.into()),
            ("dim", self.dim.into()),
            ("density", self.density.into()),
            ("motion", self.motion.as_str().into()),
            ("count", self.count.into()),
            ("contender", self.contender.as_str().into()),
            ("setting", self.setting.as_str().into()),
            ("frames", self.times.count().into()),
            ("typical_ms", self.times.typical().into()),
            ("mean_ms", self.times.mean().into()),
            ("worst_ms", self.times.worst().into()),
            ("pairs", self.pairs.into()),
            ("ratio", self.ratio.into()),
        ])
    }
}
