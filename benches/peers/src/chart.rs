//! The times of kernels as a chart in SVG: nanoseconds per box over the number of boxes, a panel for each dimension, at the higher of
//! its densities. The table has the others.
//!
//! The time is divided by the number of boxes so that the lines are nearly level and lie apart.

use crate::row::Row;
use anyhow::Result;
use std::path::Path;
use unisize_charts::{Axis, Chart, Panel, Series, color};

/// Draws the chart.
pub(crate) fn draw(rows: &[Row], folder: &Path) -> Result<()> {
    let names = names(rows);
    let panels = [2, 3].map(|dim| {
        let of_dim = || rows.iter().filter(|row| row.dim == dim);
        let density = of_dim().map(|row| row.density).fold(0.0, f64::max);
        let is_ours = |name: &&&str| name.starts_with("unisize");
        let ours = names.iter().filter(is_ours).count();
        let series = names.iter().enumerate().map(|(index, name)| {
            let color = match index.checked_sub(ours) {
                None => color::OURS[index % color::OURS.len()],
                Some(index) => color::OTHERS[index % color::OTHERS.len()],
            };
            let drawn = of_dim().filter(|row| row.contender == *name && row.density == density);
            let nanoseconds = |row: &Row| row.ms * 1e6 / row.count as f64;
            let points = drawn.map(|row| (row.count as f64, nanoseconds(row)));
            let series = Series::new(*name, color, points);
            if index == 0 { series.bold() } else { series }
        });
        let title = format!("{dim}D, density {density}");
        Panel::new(
            title,
            Axis::log("n"),
            Axis::log("nanoseconds per box"),
            series,
        )
    });
    Chart::new("All overlapping pairs of n boxes", panels)
        .write_svg(&folder.join("peers-kernels.svg"))
}

/// All contenders in the order of their first rows, but unisize's own first.
fn names(rows: &[Row]) -> Vec<&'static str> {
    let mut names = Vec::new();
    for row in rows {
        if !names.contains(&row.contender) {
            names.push(row.contender);
        }
    }
    names.sort_by_key(|name| !name.starts_with("unisize"));
    names
}
