//! The longest updates: how long a step may be held up by its broad phase, and where unisize holds it up longer than the
//! one that it replaces.

use crate::row::Row;
use crate::table::significant;
use crate::updates::{self, WITHOUT_DEFERRED};

/// Fewer colliders than this take microseconds whatever happens.
const FROM: usize = 100;

/// Prints a table of all cases of updates, and how many there are in which unisize's longest is the longer one.
pub(crate) fn print(rows: &[Row]) {
    let cases: Vec<_> = cases(rows).collect();
    if cases.is_empty() {
        return;
    }
    println!(
        "### The longest update, in milliseconds: unisize / the one that it replaces, and the ratio\n"
    );
    println!(
        "| | moves | n | frames | for Rapier 0.27 | | for 0.36 | | without what 0.36 defers | |"
    );
    println!("|---|---|--:|--:|--:|--:|--:|--:|--:|--:|");
    for case in &cases {
        let first = &case[0];
        println!(
            "| {}D, {} | {} | {} | {} | {} |",
            first.dimension,
            first.density,
            first.motion,
            first.count,
            first.frames,
            cells(case).join(" | ")
        );
    }
    println!();
    let mut times = [0; 2];
    for [ours, default] in longer(rows) {
        times[usize::from(default.contender.ends_with(WITHOUT_DEFERRED))] += 1;
        println!(
            "Longer than that of {}: {}D, density {}, {}, n = {}: {} instead of {} ms",
            default.contender,
            ours.dimension,
            ours.density,
            ours.motion,
            ours.count,
            significant(ours.worst_ms),
            significant(default.worst_ms),
        );
    }
    println!(
        "\nWith {FROM} colliders and more, unisize's longest update is the longer one in {} cases; and in {} longer than \
         what is left of Rapier's own{WITHOUT_DEFERRED}.\n",
        times[0], times[1],
    );
}

/// Unisize's and the one that it replaces, wherever its longest update is the longer one.
fn longer(rows: &[Row]) -> impl Iterator<Item = [&Row; 2]> {
    let cases = cases(rows).filter(|case| case[0].count >= FROM);
    let compared = cases.flat_map(|case| {
        let [of_027, whole, rest] = pairs(case);
        // If nothing was deferred, the last two are the same.
        let rest = rest.filter(|[_, default]| default.contender.ends_with(WITHOUT_DEFERRED));
        [of_027, whole, rest].into_iter().flatten()
    });
    compared.filter(|[ours, default]| ours.worst_ms > default.worst_ms)
}

/// The rows of updates, case by case.
fn cases(rows: &[Row]) -> impl Iterator<Item = &[Row]> {
    let cases = rows.chunk_by(|a, b| a.is_in_series_with(b) && a.count == b.count);
    cases.filter(|case| case[0].subject == "updates")
}

/// Unisize's and the one that it replaces: for Rapier 0.27, for 0.36, and for 0.36 without what its pipeline defers.
fn pairs(case: &[Row]) -> [Option<[&Row; 2]>; 3] {
    let row = |name: &str| case.iter().find(|row| row.contender == name);
    let bvh = row(updates::BVH_036);
    // If nothing was deferred, nothing is left out.
    let rest = row(&format!("{}{WITHOUT_DEFERRED}", updates::BVH_036)).or(bvh);
    [
        row(updates::OURS).zip(row(updates::BVH_027)),
        row(updates::OURS_HANDED_OVER).zip(bvh),
        row(updates::OURS_HANDED_OVER).zip(rest),
    ]
    .map(|pair| pair.map(Into::into))
}

fn cells(case: &[Row]) -> [String; 3] {
    pairs(case).map(cell)
}

fn cell(pair: Option<[&Row; 2]>) -> String {
    let Some([ours, default]) = pair else {
        return "– | –".to_owned();
    };
    let shown = [ours, default].map(|row| significant(row.worst_ms));
    let ratio = default.worst_ms / ours.worst_ms;
    format!("{} | {}", shown.join(" / "), significant(ratio))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(contender: &str, count: usize, worst_ms: f64) -> Row {
        Row {
            subject: "updates".into(),
            dimension: 2,
            density: 0.8,
            motion: "all move".into(),
            count,
            contender: contender.to_owned().into(),
            setting: String::new(),
            frames: 1,
            typical_ms: 1.0,
            mean_ms: 1.0,
            worst_ms,
            pairs: 0,
            ratio: 1.0,
        }
    }

    #[test]
    fn a_longer_update_is_found_whatever_is_deferred() {
        let bvh = updates::BVH_036;
        let rows = [
            row(updates::OURS, 10, 9.0),
            row(updates::BVH_027, 10, 1.0),
            row(updates::OURS, 100, 1.0),
            row(updates::BVH_027, 100, 2.0),
            row(updates::OURS_HANDED_OVER, 100, 5.0),
            row(bvh, 100, 4.0),
            row(&format!("{bvh}{WITHOUT_DEFERRED}"), 100, 3.0),
        ];
        let cases: Vec<_> = cases(&rows).collect();
        assert_eq!(cases.len(), 2);
        assert_eq!(
            cells(cases[1]),
            [
                "1.00 / 2.00 | 2.00",
                "5.00 / 4.00 | 0.800",
                "5.00 / 3.00 | 0.600"
            ]
        );
        // Ten are too few to count.
        let longer: Vec<_> = longer(&rows).collect();
        assert_eq!(longer.len(), 2);
        assert_eq!(longer[0][1].contender, bvh);
        assert_eq!(longer[1][1].contender, format!("{bvh}{WITHOUT_DEFERRED}"));
    }
}
