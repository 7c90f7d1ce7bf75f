//! The tables on standard output, in Markdown.

use crate::discordance::Discordance;
use crate::family::Family;
use crate::row::{Exact, Row};
use crate::shift::{Kept, Shift, Step, median};
use crate::verdict::{Verdict, least_told, probability};
use comfy_table::presets::ASCII_MARKDOWN;
use comfy_table::{CellAlignment, ColumnConstraint, Table};

/// Prints the cases of a family in one dimension.
pub(crate) fn print_family(family: Family, rows: &[Row], cases: usize) {
    let Some(first) = rows.first() else { return };
    let criterion = family.criterion();
    println!(
        "### {}D, Rapier {}: {}\n\n{} {} steps a second, {} s.\n",
        first.dim,
        crate::RAPIER,
        family.title(),
        criterion.sentence(),
        match family {
            Family::TimeSteps => "15 to 120".to_owned(),
            _ => format!("{:.0}", first.case.dt.recip()),
        },
        first.case.seconds,
    );
    let heading = criterion.heading();
    let mut table = table([
        "case".to_owned(),
        format!("{heading}, median: Rapier's"),
        "unisize".to_owned(),
        "failed: Rapier's".to_owned(),
        "unisize".to_owned(),
        "p".to_owned(),
        "fails on".to_owned(),
        "events in order".to_owned(),
        "pairs".to_owned(),
    ]);
    for row in rows {
        let [default, ours] = row.failures();
        let p = probability(ours, default).min(probability(default, ours));
        let [default_median, ours_median] = row.medians().map(figure);
        let told = |failures: crate::verdict::Failures| {
            format!("{} of {}", failures.failed, failures.runs)
        };
        table.add_row([
            row.case.label.clone(),
            default_median,
            ours_median,
            told(default),
            told(ours),
            if default == ours {
                "-".to_owned()
            } else {
                figure(p)
            },
            row.verdict(cases).name().to_owned(),
            exact(&row.in_order),
            exact(&row.pairs),
        ]);
    }
    println!("{table}\n");
    for row in rows {
        for (what, check) in [("events in order", &row.in_order), ("pairs", &row.pairs)] {
            if let Some(difference) = &check.difference {
                println!("DIFFERENCE in {}, {what}: {difference}\n", row.case.label);
            }
        }
        if let Some(message) = row.panic_alone() {
            println!("PANIC in {} on unisize alone: {message}\n", row.case.label);
        }
        for (side, ends) in [("Rapier's", &row.default), ("unisize", &row.ours)] {
            let panic = ends.iter().find_map(|end| end.measured.as_ref().err());
            if let Some(message) = panic {
                println!("A panic in {} on {side}: {message}\n", row.case.label);
            }
        }
    }
}

/// Prints how many cases fail on whom.
pub(crate) fn print_summary(rows: &[Row], cases: usize, discordance: Discordance) {
    let Some(first) = rows.first() else { return };
    println!("### Who fails, by number of cases\n");
    let mut table = table([
        "",
        "cases",
        "neither",
        "both alike",
        "Rapier's alone",
        "unisize alone",
        "equal to the bit, events in order",
        "equal pairs at every step",
    ]);
    for dim in [2, 3] {
        for family in Family::ALL {
            let of_family = rows
                .iter()
                .filter(|r| r.dim == dim && r.case.family == family);
            let of_family: Vec<_> = of_family.collect();
            if of_family.is_empty() {
                continue;
            }
            let count = |verdict: Verdict| {
                let found = of_family.iter().filter(|row| row.verdict(cases) == verdict);
                found.count().to_string()
            };
            let runs = |check: fn(&Row) -> &Exact| {
                let [equal, all, by_tree] =
                    of_family.iter().fold([0; 3], |[equal, all, by_tree], row| {
                        let check = check(row);
                        let all = all + check.runs() - check.panicked;
                        [equal + check.equal, all, by_tree + check.by_tree]
                    });
                match by_tree {
                    0 => format!("{equal} of {all} runs"),
                    _ => format!("{equal} of {all} runs, {by_tree} by the tree"),
                }
            };
            table.add_row([
                format!("{dim}D {}", family.title()),
                of_family.len().to_string(),
                count(Verdict::Neither),
                count(Verdict::Alike),
                count(Verdict::DefaultAlone),
                count(Verdict::OursAlone),
                runs(|row| &row.in_order),
                runs(|row| &row.pairs),
            ]);
        }
    }
    println!("{table}\n");
    let runs = first.ours.len();
    match least_told(runs, cases) {
        Some(failed) => println!(
            "In a single case, one fails alone from {failed} of {runs} against 0 on; what is less is \"both alike\".\n"
        ),
        None => println!(
            "In a single case, not even {runs} of {runs} against 0 would tell that one fails alone: there are too few starts for {cases} cases.\n"
        ),
    }
    println!(
        "All cases together, starts without a panic: unisize alone fails from {}, Rapier's own alone from {}. Sign test, one-sided, whether unisize fails more often: p = {}.\n",
        discordance.ours,
        discordance.default,
        figure(discordance.probability()),
    );
}

/// Prints what shifts cost in one dimension.
pub(crate) fn print_shifts(dim: u8, shifts: &[Shift]) {
    let Some(first) = shifts.first() else { return };
    println!(
        "### {dim}D, Rapier {}: a world of {} bodies is shifted in one step, {} times\n\nMilliseconds of processor time, medians.\n",
        crate::RAPIER,
        first.bodies,
        first.shifts().len()
    );
    let mut times = table([
        "scene",
        "ordinary step: Rapier's",
        "unisize",
        "with a full run: unisize",
        "the shift's update: Rapier's",
        "unisize",
        "rest of its step: Rapier's",
        "unisize",
        "each of five steps after: Rapier's",
        "unisize",
    ]);
    let mut counts = table([
        "scene",
        "full runs: step of a shift, most",
        "an ordinary step, mean",
        "candidates: ordinary",
        "after a shift",
        "equal pairs on both",
        "touching pairs: kept",
        "new",
        "lost",
    ]);
    for shift in shifts {
        let [ordinary, shifted, after] = [shift.ordinary(), shift.shifts(), shift.aftermath()];
        let ms = |ms: f64| match ms.is_nan() {
            true => "-".to_owned(),
            false => format!("{ms:.3}"),
        };
        let both = |steps: &[Step], part: fn([f64; 2]) -> f64| {
            let default = median(steps, |step| part(step.default));
            [default, median(steps, |step| part(step.ours))].map(ms)
        };
        let whole = |[first, rest]: [f64; 2]| first + rest;
        let mut row = vec![shift.scenery.name()];
        row.extend(both(&ordinary, whole));
        row.push(ms(median(&shift.with_full_run(), |step| whole(step.ours))));
        row.extend(both(&shifted, |[first, _]| first));
        row.extend(both(&shifted, |[_, rest]| rest));
        row.extend(both(&after, whole));
        times.add_row(row);

        let most = shifted.iter().map(|step| step.full_runs).max();
        let mean = ordinary.iter().map(|step| step.full_runs).sum::<u64>() as f64
            / ordinary.len().max(1) as f64;
        let candidates = |steps: &[Step]| median(steps, |step| step.candidates as f64).to_string();
        let [kept, new, lost] = match shift.kept.touches() {
            true => {
                let Kept { both, new, lost } = shift.kept;
                [both, new, lost].map(|pairs| pairs.to_string())
            }
            false => ["none touch", "-", "-"].map(str::to_owned),
        };
        counts.add_row([
            shift.scenery.name(),
            most.unwrap_or(0).to_string(),
            format!("{mean:.2}"),
            candidates(&ordinary),
            candidates(&shifted),
            match shift.difference {
                None => "yes",
                Some(_) => "NO",
            }
            .to_owned(),
            kept,
            new,
            lost,
        ]);
    }
    println!("{times}\n\n{counts}\n");
    for shift in shifts {
        if let Some(difference) = &shift.difference {
            println!("DIFFERENCE in {}: {difference}\n", shift.scenery.name());
        }
    }
}

fn exact(check: &Exact) -> String {
    match check {
        Exact { differing: 1.., .. } => {
            format!("{} of {} DIFFER", check.differing, check.runs())
        }
        Exact { by_tree: 1.., .. } => {
            format!("{} of {} by the tree", check.by_tree, check.runs())
        }
        Exact { panicked: 1.., .. } => "Rapier's panics".to_owned(),
        Exact { equal: 1.., .. } => "equal".to_owned(),
        _ => "-".to_owned(),
    }
}

/// A figure in few characters.
fn figure(figure: f64) -> String {
    match figure {
        _ if figure.is_nan() => "-".to_owned(),
        _ if figure == 0.0 || (1e-3..1e4).contains(&figure) => format!("{figure:.3}"),
        _ => format!("{figure:.1e}"),
    }
}

/// A table whose first column is text and whose others are figures.
fn table<T: Into<comfy_table::Row>>(head: T) -> Table {
    let mut table = Table::new();
    table.load_preset(ASCII_MARKDOWN).set_header(head);
    for column in table.column_iter_mut() {
        // However wide the terminal is: a line of Markdown must not be broken.
        column.set_constraint(ColumnConstraint::ContentWidth);
        if column.index > 0 {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table
}
