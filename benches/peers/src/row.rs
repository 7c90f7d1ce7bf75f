//! One figure: a contender in a case.

use anyhow::Result;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::path::Path;

/// What one contender took in one case. Times are in milliseconds a frame.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Row {
    /// `kernels` or `updates`.
    pub(crate) subject: Cow<'static, str>,
    pub(crate) dimension: usize,
    /// The part of the area or volume that the boxes would fill if they did not overlap.
    pub(crate) density: f64,
    /// What moves between two frames.
    pub(crate) motion: String,
    pub(crate) count: usize,
    pub(crate) contender: Cow<'static, str>,
    /// The setting that was best, of those that were tried.
    pub(crate) setting: String,
    pub(crate) frames: usize,
    /// The mean of the median turn.
    pub(crate) typical_ms: f64,
    /// The mean of all frames, held up or not.
    pub(crate) mean_ms: f64,
    pub(crate) worst_ms: f64,
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
            self.typical_ms
        } else {
            self.mean_ms
        }
    }

    /// Whether both are of the same case but for the number of boxes.
    pub(crate) fn is_in_series_with(&self, other: &Self) -> bool {
        self.subject == other.subject
            && self.dimension == other.dimension
            && self.density == other.density
            && self.motion == other.motion
    }
}

/// Sets the ratios of the rows of one case, of which the first is unisize's own.
pub(crate) fn set_ratios(rows: &mut [Row]) {
    let ours = rows.first().map_or(f64::NAN, Row::time_ms);
    for row in rows {
        row.ratio = row.time_ms() / ours;
    }
}

/// Replaces the file by one line for each row, under a line of names.
pub(crate) fn write_csv(rows: &[Row], file: &Path) -> Result<()> {
    let mut writer = csv::Writer::from_path(file)?;
    for row in rows {
        writer.serialize(row)?;
    }
    writer.flush()?;
    Ok(())
}

/// The rows of a file that was so written.
pub(crate) fn read_csv(file: &Path) -> Result<Vec<Row>> {
    let rows = csv::Reader::from_path(file)?.into_deserialize();
    Ok(rows.collect::<Result<_, _>>()?)
}
