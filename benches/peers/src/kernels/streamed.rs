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

/// Prints the time of StreamedSegmentTree in that of CGAL for each case in which both are; an error if it is too slow where
/// boxes are many.
pub(crate) fn check(rows: &[Row]) -> Result<()> {
    let mut too_slow = Vec::new();
    for row in rows {
        let Some([_, cgal]) = PAIRS.iter().find(|[ours, _]| row.contender == *ours) else {
            continue;
        };
        let is_cgal = |other: &&Row| {
            other.contender == *cgal && other.count == row.count && other.is_in_series_with(row)
        };
        let Some(other) = rows.iter().find(is_cgal) else {
            continue;
        };
        let ratio = row.time_ms() / other.time_ms();
        let line = format!(
            "{}D, density {}, n = {}: {} takes {ratio:.2} of CGAL's time ({}, CGAL {})",
            row.dimension, row.density, row.count, row.contender, row.setting, other.setting,
        );
        println!("{line}");
        if row.count >= LEAST_COUNT && ratio > MOST {
            too_slow.push(line);
        }
    }
    ensure!(
        too_slow.is_empty(),
        "slower than {MOST} times CGAL:\n{}",
        too_slow.join("\n")
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(contender: &'static str, dimension: usize, count: usize, typical_ms: f64) -> Row {
        Row {
            subject: "kernels".into(),
            dimension,
            density: 0.2,
            motion: String::new(),
            count,
            contender: contender.into(),
            setting: String::new(),
            frames: 1,
            typical_ms,
            mean_ms: f64::NAN,
            worst_ms: f64::NAN,
            pairs: 0,
            ratio: f64::NAN,
        }
    }

    /// One case in which CGAL takes a second at its best cutoff, and ours so much.
    fn case(count: usize, ours_ms: f64) -> [Row; 3] {
        [
            row(ours::STREAMED_AT_BEST_CUTOFF, 3, count, ours_ms),
            row(cgal::AT_BEST_CUTOFF, 2, count, 1.0),
            row(cgal::AT_BEST_CUTOFF, 3, count, 1000.0),
        ]
    }

    #[test]
    fn only_many_boxes_in_more_than_twice_the_time_are_an_error() {
        assert!(check(&case(LEAST_COUNT, 1999.0)).is_ok());
        assert!(check(&case(LEAST_COUNT - 1, 2001.0)).is_ok());
        assert!(check(&case(LEAST_COUNT, 2001.0)).is_err());
        assert!(check(&case(LEAST_COUNT, 2001.0)[..2]).is_ok());
    }
}
