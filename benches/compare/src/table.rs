//! The tables on standard output. Rows are printed as they come, so the columns have fixed widths.

use crate::forecast::forecast;
use crate::row::Row;
use unisize_scenes::{Both, End, Repeat, Times, WholeSteps};

/// The two lines of a head. A cell ends where its word in the second line ends; the first cell begins the line.
type Head = [&'static str; 2];

const RESULTS: Head = [
    "                                      whole step ms                      pairs                                        broad phase ms              without contact         sanity",
    "scene              bodies colliders   default     ours  ratio quartiles  default    ours contacts intersections equal    default      ours  ratio  default    ours  limit  default/ours",
];

const THREADS: Head = [
    "                   ms an update               forecast of ms an update on threads",
    "threads                  all  serial    of it sections        2        4        8       16",
];

/// A line of a table.
fn line([_, words]: Head, cells: impl IntoIterator<Item = String>) -> String {
    let is_end = |&end: &usize| {
        let next = words[end..].chars().next().unwrap_or(' ');
        next == ' ' && !words[..end].ends_with(' ')
    };
    let ends = (1..=words.len()).filter(is_end);
    ends.zip(cells).fold(String::new(), |line, (end, cell)| {
        if line.is_empty() {
            return cell;
        }
        let width = end.saturating_sub(line.len() + 1);
        format!("{line} {cell:>width$}")
    })
}

/// A figure of each broad phase as two cells.
fn both<T>(of: &Both<T>, cell: impl Fn(&T) -> String) -> [String; 2] {
    [cell(&of.default), cell(&of.candidate)]
}

/// The head of the table of one dimension.
pub(super) fn header(dim: u8) -> String {
    format!(
        "rapier{dim}d {}. Whole steps: each broad phase alone, queries included. The rest: the default drives, unisize \
         follows.\nWithout contact: of each broad phase alone. Limit: the ratio of whole steps with a broad phase that takes no time.\n\n{}",
        crate::RAPIER,
        RESULTS.join("\n")
    )
}

/// The result of one comparison.
pub(super) fn row(row: &Row) -> String {
    let outcome = &row.outcome;
    let mut cells = vec![
        row.scene.clone(),
        outcome.bodies.to_string(),
        outcome.colliders.to_string(),
    ];
    let mut alone = vec!["-".to_owned(); 4];
    if let Some(WholeSteps {
        ms_per_step,
        ratio,
        limit,
        repeats,
    }) = &outcome.whole_steps
    {
        cells.extend(both(ms_per_step, |ms| format!("{ms:.3}")));
        cells.push(format!("{:.3}", ratio.median));
        cells.push(format!("{:.2}-{:.2}", ratio.lower, ratio.upper));
        let verdict = |of: fn(&Both<End>) -> &End| {
            let is_sane = repeats
                .iter()
                .all(|repeat| of(&repeat.end).complaint.is_none());
            if is_sane { "ok" } else { "BAD" }
        };
        let verdicts = [verdict(|end| &end.default), verdict(|end| &end.candidate)];
        alone = both(&repeats[0].end, |end| end.pairs_without_contact.to_string()).to_vec();
        alone.push(format!("{:.2}", limit.ratio));
        alone.push(verdicts.join("/"));
    } else {
        cells.extend(vec!["-".to_owned(); 4]);
    }
    cells.extend(both(&outcome.pairs, usize::to_string));
    cells.push(outcome.contacts.at_end.to_string());
    cells.push(outcome.intersections.at_end.to_string());
    cells.push(if row.equal { "yes" } else { "NO" }.to_owned());
    let ms = |times: &Times| format!("{:.3}", times.ms_per_step);
    cells.extend(both(&outcome.broad_phase, ms));
    cells.push(format!("{:.2}", outcome.ratio));
    line(RESULTS, cells.into_iter().chain(alone))
}

/// The lines beneath the table of one dimension: means, differences, complaints about a simulation on one broad phase alone, and the
/// forecast.
pub(super) fn footer(rows: &[Row]) -> String {
    let whole_steps = rows
        .iter()
        .filter_map(|row| row.outcome.whole_steps.as_ref());
    let mut lines = vec![format!(
        "\ngeometric mean of the ratios: whole step {:.3}, broad phase {:.2}",
        geometric_mean(whole_steps.map(|whole_steps| whole_steps.ratio.median)),
        geometric_mean(rows.iter().map(|row| row.outcome.ratio)),
    )];
    for row in rows {
        if let Some(difference) = &row.outcome.first_difference {
            lines.push(format!(
                "DIFFERENCE in {} {}D: {difference}",
                row.scene, row.dim
            ));
        }
    }
    lines.extend(rows.iter().flat_map(complaints));
    lines.push(String::new());
    lines.extend(threads(rows));
    lines.join("\n")
}

/// The geometric mean; NaN of nothing.
fn geometric_mean(ratios: impl Iterator<Item = f64>) -> f64 {
    let logarithms: Vec<_> = ratios.map(f64::ln).collect();
    (logarithms.iter().sum::<f64>() / logarithms.len() as f64).exp()
}

/// The share of the updates that threads split, and a forecast of an update on more threads. There is none of a run on several threads,
/// which is a measurement itself.
fn threads(rows: &[Row]) -> Vec<String> {
    let mut lines = Vec::new();
    for row in rows.iter().filter(|row| row.threads == 1) {
        let (Some(sharing), steps) = (&row.outcome.sharing, row.outcome.steps) else {
            continue;
        };
        if lines.is_empty() {
            lines.extend(THREADS.map(str::to_owned));
        }
        let serial = sharing.ms - sharing.ms_shared;
        let a_step = |sum: f64| format!("{:.3}", sum / steps as f64);
        let mut cells = vec![row.scene.clone(), a_step(sharing.ms), a_step(serial)];
        cells.push(format!("{:.0} %", 100.0 * serial / sharing.ms));
        cells.push(format!("{:.1}", sharing.sections as f64 / steps as f64));
        let forecast = forecast(sharing, steps);
        cells.extend(forecast.map(|ms| format!("{ms:.3}")));
        lines.push(line(THREADS, cells));
    }
    if !lines.is_empty() {
        lines.push(String::new());
    }
    lines
}

/// What is wrong with the simulations of a scene on either broad phase alone.
fn complaints(row: &Row) -> Vec<String> {
    let whole_steps = row.outcome.whole_steps.iter();
    let mut lines = Vec::new();
    for Repeat { seed, end, .. } in whole_steps.flat_map(|of| &of.repeats) {
        for (name, end) in [("default", &end.default), ("ours", &end.candidate)] {
            let complaint = end.complaint.iter();
            let place = format!("{} {}D on {name}, seed {seed}", row.scene, row.dim);
            lines.extend(complaint.map(|complaint| format!("{place}: {complaint}")));
        }
    }
    lines
}
