//! The tables on standard output. Rows are printed as they come, so the columns have fixed widths.

use crate::row::Row;
use indicatif::ProgressBar;
use unisize_scenes::{Both, End, WholeSteps};

/// The two lines of a head. A cell ends where the word of the second line does, but for the first, which begins the line.
type Head = [&'static str; 2];

const RESULTS: Head = [
    "                                      whole step ms                      pairs                                        broad phase ms              without contact         sanity",
    "scene              bodies colliders   default     ours  ratio quartiles  default    ours contacts intersections equal    default      ours  ratio  default    ours  limit  default/ours",
];

const UPDATES: Head = [
    "                   mean ms             longest ms          all pairs           rays",
    "updates              default      ours   default      ours   default      ours  compared",
];

const ALONE: Head = [
    "                   asleep          left            energy                 stretch          ms of rays",
    "alone               default   ours  default   ours     default       ours  default    ours   default      ours",
];

/// Prints above the progress bar, or as usual where there is none.
fn print(bar: &ProgressBar, line: &str) {
    bar.suspend(|| println!("{line}"));
}

/// Prints a line of a table.
fn print_cells(bar: &ProgressBar, [_, words]: Head, cells: Vec<String>) {
    let is_end = |&end: &usize| {
        let next = words[end..].chars().next().unwrap_or(' ');
        next == ' ' && !words[..end].ends_with(' ')
    };
    let ends = (1..=words.len()).filter(is_end);
    let line = ends.zip(cells).fold(String::new(), |line, (end, cell)| {
        if line.is_empty() {
            return cell;
        }
        let width = end.saturating_sub(line.len() + 1);
        format!("{line} {cell:>width$}")
    });
    print(bar, &line);
}

fn print_head(bar: &ProgressBar, head: Head) {
    head.iter().for_each(|line| print(bar, line));
}

/// A figure of each broad phase as two cells.
fn both<T>(of: &Both<T>, cell: impl Fn(&T) -> String) -> [String; 2] {
    [cell(&of.default), cell(&of.candidate)]
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
    print_head(bar, RESULTS);
}

/// Prints the result of one comparison.
pub(super) fn print_row(bar: &ProgressBar, row: &Row) {
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
        let verdict = |is_sane: bool| if is_sane { "ok" } else { "BAD" };
        let default = repeats.iter().all(|of| of.end.default.complaint.is_none());
        let ours = repeats
            .iter()
            .all(|of| of.end.candidate.complaint.is_none());
        alone = both(&repeats[0].end, |end| end.pairs_without_contact.to_string()).to_vec();
        alone.push(format!("{:.2}", limit.ratio));
        alone.push(format!("{}/{}", verdict(default), verdict(ours)));
    } else {
        cells.extend(vec!["-".to_owned(); 4]);
    }
    cells.extend(both(&outcome.pairs, usize::to_string));
    cells.push(outcome.contacts.at_end.to_string());
    cells.push(outcome.intersections.at_end.to_string());
    cells.push(if row.equal { "yes" } else { "NO" }.to_owned());
    let broad_phase = &outcome.broad_phase;
    cells.extend(both(broad_phase, |times| {
        format!("{:.3}", times.ms_per_step)
    }));
    cells.push(format!("{:.2}", outcome.ratio));
    cells.extend(alone);
    print_cells(bar, RESULTS, cells);
}

/// Prints what belongs beneath the table of one dimension: means, differences, updates, and the simulations alone.
pub(super) fn print_footer(bar: &ProgressBar, rows: &[Row]) {
    let whole_steps = rows
        .iter()
        .filter_map(|row| row.outcome.whole_steps.as_ref());
    let mean = format!(
        "\ngeometric mean of the ratios: whole step {:.3}, broad phase {:.2}",
        geometric_mean(whole_steps.map(|whole_steps| whole_steps.ratio.median)),
        geometric_mean(rows.iter().map(|row| row.outcome.ratio)),
    );
    print(bar, &mean);
    for row in rows {
        if let Some(difference) = &row.outcome.first_difference {
            let line = format!("DIFFERENCE in {} {}D: {difference}", row.scene, row.dim);
            print(bar, &line);
        }
    }
    print(bar, "");
    print_updates(bar, rows);
    print(bar, "");
    print_alone(bar, rows);
    print(bar, "");
}

/// The geometric mean; NaN of nothing.
fn geometric_mean(ratios: impl Iterator<Item = f64>) -> f64 {
    let logarithms: Vec<_> = ratios.map(f64::ln).collect();
    (logarithms.iter().sum::<f64>() / logarithms.len() as f64).exp()
}

fn print_updates(bar: &ProgressBar, rows: &[Row]) {
    print_head(bar, UPDATES);
    for row in rows {
        let outcome = &row.outcome;
        let times = &outcome.broad_phase;
        let mut cells = vec![row.scene.clone()];
        cells.extend(both(times, |of| format!("{:.3}", of.ms_per_busy_update)));
        cells.extend(both(times, |of| format!("{:.3}", of.ms_worst_update)));
        cells.extend(both(&outcome.pairs_with_dropped, usize::to_string));
        cells.push(outcome.rays.cast.to_string());
        print_cells(bar, UPDATES, cells);
    }
}

/// Prints the ends of the first repeat of each scene, and all complaints.
fn print_alone(bar: &ProgressBar, rows: &[Row]) {
    let alone = rows
        .iter()
        .filter_map(|row| Some((&row.scene, row.outcome.whole_steps.as_ref()?)));
    for (index, (scene, whole_steps)) in alone.enumerate() {
        if index == 0 {
            print_head(bar, ALONE);
        }
        let end = &whole_steps.repeats[0].end;
        let mut cells = vec![scene.clone()];
        cells.extend(both(end, |end| end.asleep.to_string()));
        cells.extend(both(end, |end| end.outside.to_string()));
        cells.extend(both(end, |end| format!("{:.4e}", end.energy)));
        cells.extend(both(end, stretch));
        cells.extend(both(end, |end| format!("{:.3}", end.ms_of_rays)));
        print_cells(bar, ALONE, cells);
        for repeat in &whole_steps.repeats {
            let end = &repeat.end;
            for (name, end) in [("default", &end.default), ("ours", &end.candidate)] {
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
