//! One figure: a contender in a case.

use std::io;
use unisize_report::Report;

/// What one contender took in one case.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    pub(crate) dim: usize,
    /// The part of the area or volume that the boxes would fill if they did not overlap.
    pub(crate) density: f64,
    pub(crate) count: usize,
    pub(crate) contender: &'static str,
    /// The setting that was best, of those that were tried.
    pub(crate) setting: String,
    /// How many frames were measured.
    pub(crate) frames: usize,
    /// Milliseconds a frame.
    pub(crate) ms: f64,
    /// The pairs of the last frame.
    pub(crate) pairs: usize,
    /// Its time in that of unisize's own in this case: above 1, unisize is faster.
    pub(crate) ratio: f64,
}

impl Row {
    /// Prints the row, and writes it.
    pub(crate) fn report(&self, report: &mut Report) -> io::Result<()> {
        report.row(&[
            ("subject", "kernels".into()),
            ("dim", self.dim.into()),
            ("density", self.density.into()),
            ("count", self.count.into()),
            ("contender", self.contender.into()),
            ("setting", self.setting.as_str().into()),
            ("frames", self.frames.into()),
            ("typical_ms", self.ms.into()),
            ("pairs", self.pairs.into()),
            ("ratio", self.ratio.into()),
        ])
    }
}
