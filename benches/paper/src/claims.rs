//! The claims of the paper that come down to a ratio: its figure, ours, and a verdict.

use crate::published::{CONVERGING, THREADS};
use crate::run::{Run, count};
use crate::table1::row;
use crate::third_axis::COUNTS;
use std::io;

/// A figure of ours within this factor of the paper's reproduces it.
const TOLERANCE: f64 = 1.5;

/// Adds those whose parts were measured at the sizes of the paper.
pub(crate) fn judge(run: &mut Run) -> io::Result<()> {
    let row = |density: f64, size: u32| row(density, 1 << size);
    let (largest, smaller, sparse) = (&row(0.8, 20), &row(0.8, 17), &row(0.2, 20));
    let cell = |part: &str, row: &str, column: &str| run.number(part, row, column);
    // One column over another, and one row over another.
    let columns = |part: &str, row: &str, above: &str, below: &str| {
        Some(cell(part, row, above)? / cell(part, row, below)?)
    };
    let rows = |part: &str, column: &str, above: &str, below: &str| {
        Some(cell(part, above, column)? / cell(part, below, column)?)
    };
    let table1 = |above: &str, below: &str| columns("table1", largest, above, below);
    let (ours, theirs) = ("rank_sweep", "theirs");
    let (time, their_time) = ("rank_sweep_ns", "their_ns");
    let of_phase = |column: &str| cell("figure3", largest, column);
    let [above, below] = [COUNTS[3], COUNTS[1]];
    let [more, fewer] = [count(above), count(below)];
    let growth = rows("third-axis-growth", "rank_sweep", &more, &fewer);
    let exponent = growth.map(|growth| growth.ln() / (above as f64 / below as f64).ln());
    let claims = [
        (
            "milliseconds for 2<sup>20</sup> squares, d = 0.8",
            cell("table1", largest, theirs),
            cell("table1", largest, ours),
        ),
        (
            "sweep and prune over theirs, the same",
            table1("bar92", theirs),
            table1("sweep_and_prune", ours),
        ),
        (
            "time at d = 0.8 over that at d = 0.2",
            rows("table1", theirs, largest, sparse),
            rows("table1", ours, largest, sparse),
        ),
        (
            "time per collision, 2<sup>20</sup> over 2<sup>17</sup> squares",
            rows("figure3", their_time, largest, smaller),
            rows("figure3", time, largest, smaller),
        ),
        (
            "time per collision, d = 0.2 over d = 0.8",
            rows("figure3", their_time, sparse, largest),
            rows("figure3", time, sparse, largest),
        ),
        (
            "share of the pairing phase, d = 0.8",
            of_phase("their_share"),
            of_phase("share"),
        ),
        (
            "converging squares, worst frame over the median",
            Some(CONVERGING[0] / CONVERGING[2]),
            cell("figure4", "RankSweep", "worst_over_median"),
        ),
        ("cubes: the exponent of n, more than 1", None, exponent),
        ("two threads", Some(THREADS), cell("threads", largest, ours)),
    ];
    for (claim, paper, here) in claims {
        if let Some(here) = here {
            let columns = [
                ("paper", paper.into()),
                ("here", here.into()),
                ("verdict", verdict(paper, here).into()),
            ];
            run.row("claims", claim, &columns)?;
        }
    }
    Ok(())
}

/// What a figure of ours says of the paper's; where it gives none, whether ours is more than 1.
fn verdict(paper: Option<f64>, here: f64) -> &'static str {
    let ratio = here / paper.unwrap_or(here);
    match paper {
        None if here > 1.0 => "reproduced",
        Some(_) if (1.0 / TOLERANCE..=TOLERANCE).contains(&ratio) => "reproduced",
        _ => "not reproduced",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn verdicts_follow_the_figures() {
        assert_eq!(verdict(Some(5.08), 4.51), "reproduced");
        assert_eq!(verdict(Some(17.4), 1.61), "not reproduced");
        assert_eq!(verdict(Some(1.0), 1.6), "not reproduced");
        assert_eq!(verdict(None, 14.0), "reproduced");
        assert_eq!(verdict(None, 0.9), "not reproduced");
        assert_eq!(verdict(Some(1.0), f64::NAN), "not reproduced");
    }

    #[test]
    fn what_was_not_measured_is_not_judged() {
        let mut run = Run::new(false, None).unwrap();
        let columns = [("rank_sweep", 1.29.into())];
        run.row("threads", &row(0.8, 1 << 20), &columns).unwrap();
        judge(&mut run).unwrap();
        assert_eq!(run.number("claims", "two threads", "here"), Some(1.29));
        let exponent = "cubes: the exponent of n, more than 1";
        assert_eq!(run.number("claims", exponent, "here"), None);
    }
}
