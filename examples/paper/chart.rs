//! Line charts in SVG: panels side by side, and one legend below them.

mod axis;
mod legend;
mod panel;

use anyhow::{Result, anyhow};
pub(crate) use axis::Axis;
use plotters::prelude::*;
use std::path::Path;

const PANEL_SIZE: (u32, u32) = (420, 360);
const TITLE_HEIGHT: u32 = 40;
const LEGEND_ROW_HEIGHT: u32 = 22;

/// A line through points.
#[derive(Clone, Debug)]
pub(crate) struct Line {
    name: String,
    color: RGBColor,
    points: Vec<(f64, f64)>,
}

impl Line {
    pub(crate) fn new(name: &str, color: RGBColor, points: Vec<(f64, f64)>) -> Self {
        Self {
            name: name.to_owned(),
            color,
            points,
        }
    }
}

/// One panel.
#[derive(Clone, Debug)]
pub(crate) struct Panel {
    pub(crate) title: String,
    pub(crate) x: Axis,
    pub(crate) y: Axis,
    pub(crate) lines: Vec<Line>,
    /// A line with an axis of its own on the right.
    pub(crate) right: Option<(Axis, Line)>,
}

/// Draws panels, so many in a row. All with the same axes have the same range of them.
pub(crate) fn draw(file: &Path, title: &str, panels: &[Panel], columns: usize) -> Result<()> {
    draw_panels(file, title, panels, columns)
        .map_err(|error| anyhow!("cannot draw {}: {error}", file.display()))
}

fn draw_panels(
    file: &Path,
    title: &str,
    panels: &[Panel],
    columns: usize,
) -> Result<(), Box<dyn std::error::Error>> {
    let columns = columns.clamp(1, panels.len().max(1));
    let rows = panels.len().div_ceil(columns);
    // A single panel is a wide one.
    let (panel_width, panel_height) = match panels.len() {
        1 => (2 * PANEL_SIZE.0, PANEL_SIZE.1 + 40),
        _ => PANEL_SIZE,
    };
    let width = panel_width * columns as u32;
    let entries = legend::entries(panels);
    let legend_height = LEGEND_ROW_HEIGHT * legend::rows(entries.len(), width) + 10;
    let panels_height = panel_height * rows as u32;
    let size = (width, TITLE_HEIGHT + panels_height + legend_height);

    let root = SVGBackend::new(file, size).into_drawing_area();
    root.fill(&WHITE)?;
    let root = root.titled(title, ("sans-serif", 22))?;
    let (upper, lower) = root.split_vertically(panels_height);
    for (area, panel) in upper.split_evenly((rows, columns)).iter().zip(panels) {
        panel.draw(area, panels)?;
    }
    legend::draw(&lower, &entries)?;
    root.present()?;
    Ok(())
}
