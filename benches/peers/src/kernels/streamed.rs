//! Whether StreamedSegmentTree is as fast as CGAL, whose algorithm it is: only then can it stand for CGAL elsewhere.

use super::{cgal, ours};
use crate::row::Row;
use anyhow::{Result, ensure};

/// How many times as long as CGAL it may take at most.
const MOST: f64 = 2.0;

/// With fewer boxes a frame takes some milliseconds, which is too little to fail for.
const LEAST_COUNT: usize = 1 << 17;

/// Ours, and what it is compared with.
const PAIRS: [[&str; 2]; 2] = [
    [ours::STREAMED_AT_DEFAULT_CUTOFF, cgal::AT_DEFAULT_CUTOFF],
    [ours::STREAMED_AT_BEST_CUTOFF, cgal::AT_BEST_CUTOFF],
];

/// An error if it is too slow in a case that both have and in which boxes are many.
pub(crate) fn check(rows: &[Row]) -> Result<()> {
    for row in rows.iter().filter(|row| row.count >= LEAST_COUNT) {
        let replaced = PAIRS.iter().find(|[ours, _]| row.contender == *ours);
        let is_cgal = |other: &&Row| {
            replaced.is_some_and(|[_, cgal]| other.contender == *cgal)
                && other.count == row.count
                && other.is_in_series_with(row)
        };
        if let Some(cgal) = rows.iter().find(is_cgal) {
            let ratio = row.time_ms() / cgal.time_ms();
            ensure!(
                ratio <= MOST,
                "{row:?} took {ratio:.2} of the time of {cgal:?}"
            );
        }
    }
    Ok(())
}
