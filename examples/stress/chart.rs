//! The charts in SVG: how many runs fail against what is taken to its limit; a panel for each family.

use crate::family::Family;
use crate::row::Row;
use anyhow::Result;
use std::path::Path;
use unisize_charts::{Axis, Chart, Panel, Series, color};

const COLUMNS: usize = 3;

/// Draws the cases of one dimension.
pub(crate) fn draw(file: &Path, dim: u8, rows: &[&Row]) -> Result<()> {
    let panels = Family::ALL.into_iter().filter_map(|family| {
        let of_family: Vec<_> = rows
            .iter()
            .filter(|row| row.case.family == family)
            .collect();
        (!of_family.is_empty()).then(|| panel(family, &of_family))
    });
    let title = format!("Where small worlds fail, {dim}D, Rapier {}", crate::RAPIER);
    Chart::new(title, panels)
        .columns(COLUMNS)
        .own_ranges()
        .note("The broad line is Rapier's own broad phase, the thin one unisize: where both fail alike, one lies upon the other.")
        .write_svg(file)
}

/// Both broad phases in one family.
fn panel(family: Family, rows: &[&&Row]) -> Panel {
    let of_side = |side: usize| {
        rows.iter().map(move |row| {
            let failures = row.failures()[side];
            let share = failures.failed as f64 / failures.runs.max(1) as f64;
            (parameter(row), 100.0 * share)
        })
    };
    let axis = Axis::log(family.parameter());
    Panel::new(
        family.title(),
        match family {
            // The origin has a place of its own.
            Family::Offsets => axis.with_zero_between(50.0, 200.0),
            Family::Extremes => Axis::linear("speed, as a power of ten"),
            _ => axis,
        },
        Axis::linear("runs that fail, %").reaching(100.0),
        // The first one lies on top.
        [
            Series::new("unisize", color::RED, of_side(1)),
            Series::new("Rapier's own broad phase", color::SKY, of_side(0)).bold(),
        ],
    )
}

/// Where a case is along the axis. Speeds at the limits of the numbers span too much for a logarithmic one.
fn parameter(row: &Row) -> f64 {
    match row.case.family {
        Family::Extremes => row.case.parameter.log10(),
        _ => row.case.parameter,
    }
}
