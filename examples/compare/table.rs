//! The tables on standard output. Rows are printed as they come, so the columns have fixed widths.

use crate::row::{End, Row, Sides, WholeSteps};
use indicatif::ProgressBar;

/// Prints above the progress bar, or as usual where there is none.
fn print(bar: &ProgressBar, line: &str) {
    bar.suspend(|| println!("{line}"));
}

/// Prints the head of the table of one dimension.
pub(super) fn print_header(bar: &ProgressBar, dim: u8) {
    print(
        bar,
        &format!(
            "rapier{dim}d {}. Whole steps: each broad phase alone, queries included. The rest: the default drives, unisize \
             follows.\nWithout contact: of each broad phase alone. Limit: the ratio of whole steps with a broad phase that takes no time.\n",
            crate::RAPIER
        ),
    );
    let head = format!(
        "{:18} {:>6} {:>9}  {:>17} {:>6} {:>9}  {:>15} {:>8} {:>9} {:>5}  {:>19} {:>6}  {:>15} {:>6}  {}",
        "scene",
        "bodies",
        "colliders",
        "whole step ms",
        "ratio",
        "quartiles",
        "pairs",
        "contacts",
        "intersec-",
        "equal",
        "broad phase ms/step",
        "ratio",
        "without contact",
        "limit",
        "sanity"
    );
    print(bar, &head);
    let head = format!(
        "{:18} {:>6} {:>9}  {:>8} {:>8} {:>6} {:>9}  {:>7} {:>7} {:>8} {:>9} {:>5}  {:>9} {:>9} {:>6}  {:>7} {:>7} {:>6}  {}",
        "",
        "",
        "",
        "default",
        "ours",
        "",
        "",
        "default",
        "ours",
        "",
        "tions",
        "",
        "default",
        "ours",
        "",
        "default",
        "ours",
        "",
        "default/ours"
    );
    print(bar, &head);
}

/// Prints the result of one comparison.
pub(super) fn print_row(bar: &ProgressBar, row: &Row) {
    let (whole_steps, alone) = match &row.whole_steps {
        Some(whole_steps) => (
            format!(
                "{:>8.3} {:>8.3} {:>6.3} {:>9}",
                whole_steps.ms_per_step.default,
                whole_steps.ms_per_step.ours,
                whole_steps.ratio.median,
                format!(
                    "{:.2}-{:.2}",
                    whole_steps.ratio.lower, whole_steps.ratio.upper
                ),
            ),
            format!(
                "{:>7} {:>7} {:>6.2}  {}/{}",
                whole_steps.repeats[0].end.default.pairs_without_contact,
                whole_steps.repeats[0].end.ours.pairs_without_contact,
                whole_steps.limit.ratio,
                verdict(whole_steps, |end| &end.default),
                verdict(whole_steps, |end| &end.ours)
            ),
        ),
        None => (
            format!("{:>8} {:>8} {:>6} {:>9}", "-", "-", "-", "-"),
            format!("{:>7} {:>7} {:>6}  -", "-", "-", "-"),
        ),
    };
    let line = format!(
        "{:18} {:>6} {:>9}  {whole_steps}  {:>7} {:>7} {:>8} {:>9} {:>5}  {:>9.3} {:>9.3} {:>6.2}  {alone}",
        row.scene,
        row.bodies,
        row.colliders,
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

fn verdict(whole_steps: &WholeSteps, side: fn(&Sides<End>) -> &End) -> &'static str {
    let mut ends = whole_steps.repeats.iter().map(|repeat| side(&repeat.end));
    if ends.all(|end| end.complaint.is_none()) {
        "ok"
    } else {
        "BAD"
    }
}

/// Prints what belongs beneath the table of one dimension: means, differences, updates, and the simulations alone.
pub(super) fn print_footer<'a>(bar: &ProgressBar, rows: impl Iterator<Item = &'a Row> + Clone) {
    let whole_steps = rows.clone().filter_map(|row| row.whole_steps.as_ref());
    let mean = format!(
        "\ngeometric mean of the ratios: whole step {:.3}, broad phase {:.2}",
        geometric_mean(whole_steps.map(|whole_steps| whole_steps.ratio.median)),
        geometric_mean(rows.clone().map(|row| row.ratio)),
    );
    print(bar, &mean);
    for row in rows.clone() {
        if let Some(difference) = &row.first_difference {
            print(
                bar,
                &format!("DIFFERENCE in {} {}D: {difference}", row.scene, row.dim),
            );
        }
    }
    print_updates(bar, rows.clone());
    let mut alone = rows
        .filter_map(|row| Some((row, row.whole_steps.as_ref()?)))
        .peekable();
    if alone.peek().is_some() {
        print_alone(bar, alone);
    }
    print(bar, "");
}

/// The geometric mean; NaN of nothing.
fn geometric_mean(ratios: impl Iterator<Item = f64>) -> f64 {
    let logarithms: Vec<_> = ratios.map(f64::ln).collect();
    (logarithms.iter().sum::<f64>() / logarithms.len() as f64).exp()
}

fn print_updates<'a>(bar: &ProgressBar, rows: impl Iterator<Item = &'a Row>) {
    let head = format!(
        "\n{:18} {:>19}  {:>19}  {:>17} {:>8}",
        "updates, ms", "mean", "longest", "pairs, all", "rays"
    );
    print(bar, &head);
    let head = format!(
        "{:18} {:>9} {:>9}  {:>9} {:>9}  {:>8} {:>8} {:>8}",
        "", "default", "ours", "default", "ours", "default", "ours", "compared"
    );
    print(bar, &head);
    for row in rows {
        let Sides { default, ours } = &row.broad_phase;
        let line = format!(
            "{:18} {:>9.3} {:>9.3}  {:>9.3} {:>9.3}  {:>8} {:>8} {:>8}",
            row.scene,
            default.ms_per_busy_update,
            ours.ms_per_busy_update,
            default.ms_worst_update,
            ours.ms_worst_update,
            row.pairs_with_dropped.default,
            row.pairs_with_dropped.ours,
            row.rays.cast,
        );
        print(bar, &line);
    }
}

/// Prints the ends of the first repeat of each scene, and all complaints.
fn print_alone<'a>(bar: &ProgressBar, rows: impl Iterator<Item = (&'a Row, &'a WholeSteps)>) {
    let head = format!(
        "\n{:18} {:>6} {:>6} {:>6} {:>6} {:>10} {:>10} {:>7} {:>7} {:>19}",
        "each alone", "asleep", "", "left", "", "energy", "", "stretch", "", "rays, ms/step"
    );
    print(bar, &head);
    let head = format!(
        "{:18} {:>6} {:>6} {:>6} {:>6} {:>10} {:>10} {:>7} {:>7} {:>9} {:>9}",
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
    for (row, whole_steps) in rows {
        let Sides { default, ours } = &whole_steps.repeats[0].end;
        let line = format!(
            "{:18} {:>6} {:>6} {:>6} {:>6} {:>10.4e} {:>10.4e} {:>7} {:>7} {:>9.3} {:>9.3}",
            row.scene,
            default.asleep,
            ours.asleep,
            default.outside,
            ours.outside,
            default.energy,
            ours.energy,
            stretch(default),
            stretch(ours),
            default.ms_of_rays,
            ours.ms_of_rays,
        );
        print(bar, &line);
        for repeat in &whole_steps.repeats {
            for (name, end) in [("default", &repeat.end.default), ("ours", &repeat.end.ours)] {
                if let Some(complaint) = &end.complaint {
                    let seed = repeat.seed;
                    print(bar, &format!("  on {name}, seed {seed}: {complaint}"));
                }
            }
        }
    }
}

fn stretch(end: &End) -> String {
    end.max_rope_stretch
        .map_or_else(|| "-".to_owned(), |stretch| format!("{stretch:.3}"))
}
