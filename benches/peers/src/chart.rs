//! The rows as charts in SVG: nanoseconds per box over the number of boxes, a panel for each case.
//!
//! The time is divided by the number of boxes so that the lines are nearly level and lie apart.

use crate::row::Row;
use crate::updates::WITHOUT_DEFERRED;
use anyhow::Result;
use std::collections::BTreeSet;
use std::path::Path;
use unisize_charts::{Axis, Chart, Panel, Series, color};

/// Draws a chart of each subject that has rows.
pub(crate) fn draw(rows: &[Row], folder: &Path) -> Result<()> {
    let charts = [
        (
            "kernels",
            "peers-kernels.svg",
            "All overlapping pairs of n boxes",
        ),
        (
            "updates",
            "peers-update.svg",
            "One update of a broad phase of n colliders",
        ),
    ];
    for (subject, name, title) in charts {
        let is_drawn = |row: &&Row| {
            // What Rapier 0.36 takes without what it defers appears only in the table.
            row.subject == subject && !row.contender.ends_with(WITHOUT_DEFERRED)
        };
        let rows: Vec<_> = rows.iter().filter(is_drawn).collect();
        let cases = cases(&rows);
        if cases.is_empty() {
            continue;
        }
        let contenders = contenders(&cases);
        let panels = cases.iter().map(|case| panel(case, &contenders));
        Chart::new(title, panels)
            .columns(columns(&cases))
            .write_svg(&folder.join(name))?;
    }
    Ok(())
}

/// The rows of one case, at every number of boxes.
type Case<'a> = &'a [&'a Row];

/// The cases that are drawn: of each dimension's densities the highest, and only cases with more than two numbers of boxes.
/// The table has the others.
fn cases<'a>(rows: &'a [&'a Row]) -> Vec<Case<'a>> {
    let cases = rows.chunk_by(|a, b| a.is_in_series_with(b));
    let is_drawn = |case: &Case<'_>| {
        let counts: BTreeSet<_> = case.iter().map(|row| row.count).collect();
        let is_densest = rows
            .iter()
            .all(|row| row.dim != case[0].dim || row.density <= case[0].density);
        is_densest && counts.len() > 2
    };
    cases.filter(is_drawn).collect()
}

/// All contenders in the order of their first rows, but unisize's own first.
fn contenders<'a>(cases: &[Case<'a>]) -> Vec<&'a str> {
    let mut contenders = Vec::new();
    for row in cases.iter().copied().flatten() {
        if !contenders.contains(&row.contender.as_str()) {
            contenders.push(row.contender.as_str());
        }
    }
    contenders.sort_by_key(|name| !name.starts_with("unisize"));
    contenders
}

/// One row of panels per dimension, or one row of all panels if each dimension has only one.
fn columns(cases: &[Case<'_>]) -> usize {
    let is_of_first = |case: &&Case<'_>| case[0].dim == cases[0][0].dim;
    match cases.iter().take_while(is_of_first).count() {
        1 => cases.len(),
        columns => columns,
    }
}

fn panel(case: Case<'_>, contenders: &[&str]) -> Panel {
    let is_ours = |name: &&&str| name.starts_with("unisize");
    let ours = contenders.iter().filter(is_ours).count();
    let series = contenders.iter().enumerate().map(|(index, contender)| {
        let color = match index.checked_sub(ours) {
            None => color::OURS[index % color::OURS.len()],
            Some(index) => color::OTHERS[index % color::OTHERS.len()],
        };
        let rows = case.iter().filter(|row| row.contender == *contender);
        let points = rows.map(|row| (row.count as f64, row.time_ms() * 1e6 / row.count as f64));
        let series = Series::new(*contender, color, points);
        if index == 0 { series.bold() } else { series }
    });
    let first = case[0];
    let mut title = format!("{}D, density {}", first.dim, first.density);
    if !first.motion.is_empty() {
        title = format!("{title}, {}", first.motion);
    }
    Panel::new(
        title,
        Axis::log("n"),
        Axis::log("nanoseconds per box"),
        series,
    )
}
