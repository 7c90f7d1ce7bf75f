//! The claims of the paper that come down to a ratio: its figure, ours, and a verdict.

use crate::published::{CONVERGING, THREADS};
use crate::table::{Table, count};
use crate::table1::row;
use crate::third_axis::COUNTS;

/// A figure of ours within this factor of the paper's reproduces it.
const TOLERANCE: f64 = 1.5;

/// Adds those whose parts were measured at the sizes of the paper.
pub(crate) fn judge(table: &mut Table) {
    let row = |density: f64, size: u32| row(density, 1 << size);
    let (largest, smaller, sparse) = (&row(0.8, 20), &row(0.8, 17), &row(0.2, 20));
    let cell = |part: &str, row: &str, column: &str| table.number(part, row, column);
    // One column over another, and one row over another.
    let columns = |part: &str, row: &str, above: &str, below: &str| {
        Some(cell(part, row, above)? / cell(part, row, below)?)
    };
    let rows = |part: &str, column: &str, above: &str, below: &str| {
        Some(cell(part, above, column)? / cell(part, below, column)?)
    };
    let table1 = |above: &str, below: &str| columns("table1", largest, above, below);
    let (ours, theirs) = ("RankSweep", "paper: theirs");
    let (time, their_time) = ("t_c, ns", "paper: t_c, ns");
    let of_phase = |column: &str| cell("figure3", largest, column);
    let [above, below] = [COUNTS[3], COUNTS[1]];
    let [more, fewer] = [count(above), count(below)];
    let growth = rows("third-axis-growth", "RankSweep, ms", &more, &fewer);
    let exponent = growth.map(|growth| growth.ln() / (above as f64 / below as f64).ln());
    let claims = [
        (
            "milliseconds for 2<sup>20</sup> squares, d = 0.8",
            cell("table1", largest, theirs),
            cell("table1", largest, ours),
        ),
        (
            "sweep and prune over theirs, the same",
            table1("paper: Bar92", theirs),
            table1("SweepAndPrune", ours),
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
            of_phase("paper: share of t_p"),
            of_phase("share of t_p"),
        ),
        (
            "converging squares, worst frame over the median",
            Some(CONVERGING[0] / CONVERGING[2]),
            cell("figure4", ours, "worst / median"),
        ),
        ("cubes: the exponent of n, more than 1", None, exponent),
        (
            "two threads",
            Some(THREADS),
            cell("threads", largest, "RankSweep: all"),
        ),
    ];
    for (claim, paper, here) in claims {
        let Some(here) = here else {
            continue;
        };
        if let Some(paper) = paper {
            table.add("claims", claim, "paper", paper);
        }
        table.add("claims", claim, "here", here);
        table.add("claims", claim, "verdict", verdict(paper, here));
    }
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
        let mut table = Table::default();
        table.add("threads", row(0.8, 1 << 20), "RankSweep: all", 1.29);
        judge(&mut table);
        assert_eq!(table.number("claims", "two threads", "here"), Some(1.29));
        assert_eq!(
            table.number("claims", "cubes: the exponent of n, more than 1", "here"),
            None
        );
    }
}
