//! The charts in SVG: what each method holds beyond what touches, against what it costs; a panel for each scene.

mod labels;
mod legend;
mod panel;
mod ticks;

use crate::study::Study;
use panel::Panel;
use plotters::prelude::*;
use std::path::Path;

const COLUMNS: usize = 3;
const PANEL_SIZE: (u32, u32) = (430, 390);
const TITLE_HEIGHT: u32 = 40;
const LEGEND_HEIGHT: u32 = 60;

/// Draws the studies of one dimension.
pub(crate) fn draw(
    file: &Path,
    dim: u8,
    studies: &[&Study],
) -> Result<(), Box<dyn std::error::Error>> {
    let columns = studies.len().clamp(1, COLUMNS);
    let lines = studies.len().div_ceil(columns);
    let panels_height = PANEL_SIZE.1 * lines as u32;
    let width = PANEL_SIZE.0 * COLUMNS.max(columns) as u32;
    let size = (width, TITLE_HEIGHT + panels_height + LEGEND_HEIGHT);
    let root = SVGBackend::new(file, size).into_drawing_area();
    root.fill(&WHITE)?;
    let title = format!("What a margin costs, {dim}D: left is precise, low is fast");
    let root = root.titled(&title, ("sans-serif", 22))?;
    let (upper, lower) = root.split_vertically(panels_height);
    for (area, study) in upper.split_evenly((lines, columns)).iter().zip(studies) {
        Panel::of(study).draw(area)?;
    }
    legend::draw(&lower, studies)?;
    root.present()?;
    Ok(())
}
