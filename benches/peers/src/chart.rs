//! The rows as charts in SVG: the time for one box against the number of boxes, a panel for each case.
//!
//! The time is divided by the number of boxes, so that lines are about level and lie apart; both axes are
//! logarithmic, and all panels of a chart have the same.

mod legend;
mod panel;

use crate::row::Row;
use anyhow::{Result, anyhow};
use legend::Legend;
use panel::{Panel, Ranges};
use plotters::prelude::*;
use std::path::{Path, PathBuf};

const PANEL_SIZE: (u32, u32) = (420, 380);
const TITLE_HEIGHT: u32 = 40;
const LEGEND_ROW_HEIGHT: u32 = 22;

/// The reference algorithms, which are in the table only: CGAL's is drawn as CGAL.
const NOT_DRAWN: [&str; 1] = ["unisize StreamedSegmentTree"];

/// Draws a chart of each subject that there are rows of, and returns their files.
pub(crate) fn draw(rows: &[Row], folder: &Path) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
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
            let mut left_out = NOT_DRAWN.iter();
            row.subject == subject && !left_out.any(|name| row.contender.starts_with(name))
        };
        let rows: Vec<_> = rows.iter().filter(is_drawn).collect();
        let panels = panel::of_rows(&rows);
        if !panels.is_empty() {
            let file = folder.join(name);
            draw_chart(&file, title, &panels)
                .map_err(|error| anyhow!("cannot draw {}: {error}", file.display()))?;
            files.push(file);
        }
    }
    Ok(files)
}

fn draw_chart(
    file: &Path,
    title: &str,
    panels: &[Panel<'_>],
) -> Result<(), Box<dyn std::error::Error>> {
    let legend = Legend::new(panels);
    let columns = panel::columns(panels);
    let lines = panels.len().div_ceil(columns);
    let width = PANEL_SIZE.0 * columns as u32;
    let panels_height = PANEL_SIZE.1 * lines as u32;
    let legend_height = LEGEND_ROW_HEIGHT * legend.rows(width) + 10;
    let size = (width, TITLE_HEIGHT + panels_height + legend_height);

    let root = SVGBackend::new(file, size).into_drawing_area();
    root.fill(&WHITE)?;
    let root = root.titled(title, ("sans-serif", 22))?;
    let (upper, lower) = root.split_vertically(panels_height);
    let ranges = Ranges::of(panels);
    for (area, panel) in upper.split_evenly((lines, columns)).iter().zip(panels) {
        panel.draw(area, &legend, &ranges)?;
    }
    legend.draw(&lower)?;
    root.present()?;
    Ok(())
}
