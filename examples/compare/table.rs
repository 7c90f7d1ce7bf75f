//! The tables on standard output. Rows are printed as they come, so the columns have fixed widths.

use crate::row::{End, Row, Sides};
use indicatif::ProgressBar;

/// Prints above the progress bar, or as usual where there is none.
fn print(bar: &ProgressBar, line: &str) {
    bar.suspend(|| println!("{line}"));
}

/// Prints the head of the table of one dimension.
pub(super) fn print_header(bar: &ProgressBar, dim: u8) {
    print(
        bar,
        &format!("rapier{dim}d: the default broad phase drives, unisize follows\n"),
    );
    let head = format!(
        "{:14} {:>7} {:>17} {:>9} {:>9} {:>5}  {:>19} {:>6}  {}",
        "scene",
        "bodies",
        "pairs",
        "contacts",
        "intersec-",
        "equal",
        "broad phase ms/step",
        "ratio",
        "sanity"
    );
    print(bar, &head);
    let head = format!(
        "{:14} {:>7} {:>8} {:>8} {:>9} {:>9} {:>5}  {:>9} {:>9} {:>6}  {}",
        "", "", "default", "ours", "", "tions", "", "default", "ours", "", "default/ours"
    );
    print(bar, &head);
}

/// Prints the result of one comparison.
pub(super) fn print_row(bar: &ProgressBar, row: &Row) {
    let sanity = row.independent.as_ref().map_or_else(
        || "-".to_owned(),
        |ends| format!("{}/{}", verdict(&ends.default), verdict(&ends.ours)),
    );
    let line = format!(
        "{:14} {:>7} {:>8} {:>8} {:>9} {:>9} {:>5}  {:>9.3} {:>9.3} {:>6.2}  {sanity}",
        row.scene,
        row.bodies,
        row.pairs.default,
        row.pairs.ours,
        row.contacts.at_end,
        row.intersections.at_end,
        if row.equal { "yes" } else { "NO" },
        row.broad_phase.default.ms_per_step,
        row.broad_phase.ours.ms_per_step,
        row.ratio,
    );
    print(bar, &line);
}

fn verdict(end: &End) -> &'static str {
    if end.complaint.is_none() { "ok" } else { "BAD" }
}

/// Prints what belongs beneath the table of one dimension: differences, and the simulations alone.
pub(super) fn print_footer<'a>(bar: &ProgressBar, rows: impl Iterator<Item = &'a Row> + Clone) {
    let count = rows.clone().count() as f64;
    let mean = (rows.clone().map(|row| row.ratio.ln()).sum::<f64>() / count).exp();
    print(bar, &format!("\ngeometric mean of the ratios: {mean:.2}"));
    for row in rows.clone() {
        if let Some(difference) = &row.first_difference {
            print(
                bar,
                &format!("DIFFERENCE in {} {}D: {difference}", row.scene, row.dim),
            );
        }
    }
    let mut alone = rows
        .filter_map(|row| Some((row, row.independent.as_ref()?)))
        .peekable();
    if alone.peek().is_some() {
        print_alone(bar, alone);
    }
    print(bar, "");
}

fn print_alone<'a>(bar: &ProgressBar, rows: impl Iterator<Item = (&'a Row, &'a Sides<End>)>) {
    let head = format!(
        "\n{:14} {:>6} {:>6} {:>6} {:>6} {:>10} {:>10} {:>7} {:>7} {:>9} {:>9}",
        "each alone", "asleep", "", "left", "", "energy", "", "stretch", "", "ms/step", ""
    );
    print(bar, &head);
    let head = format!(
        "{:14} {:>6} {:>6} {:>6} {:>6} {:>10} {:>10} {:>7} {:>7} {:>9} {:>9}",
        "",
        "deflt",
        "ours",
        "deflt",
        "ours",
        "default",
        "ours",
        "default",
        "ours",
        "default",
        "ours"
    );
    print(bar, &head);
    for (row, Sides { default, ours }) in rows {
        let line = format!(
            "{:14} {:>6} {:>6} {:>6} {:>6} {:>10.4e} {:>10.4e} {:>7} {:>7} {:>9.3} {:>9.3}",
            row.scene,
            default.asleep,
            ours.asleep,
            default.outside,
            ours.outside,
            default.energy,
            ours.energy,
            stretch(default),
            stretch(ours),
            default.ms_per_step,
            ours.ms_per_step,
        );
        print(bar, &line);
        for (name, end) in [("default", default), ("ours", ours)] {
            if let Some(complaint) = &end.complaint {
                print(bar, &format!("  on {name}: {complaint}"));
            }
        }
    }
}

fn stretch(end: &End) -> String {
    end.max_rope_stretch
        .map_or_else(|| "-".to_owned(), |stretch| format!("{stretch:.3}"))
}
