//! The legend below the panels: each name once.

use super::{LEGEND_ROW_HEIGHT, Panel};
use plotters::coord::Shift;
use plotters::prelude::*;

const ENTRY_WIDTH: u32 = 250;

/// The names and colours in order.
pub(super) fn entries(panels: &[Panel]) -> Vec<(String, RGBColor)> {
    let mut entries: Vec<(String, RGBColor)> = Vec::new();
    for panel in panels {
        let right = panel.right.iter().map(|(_, line)| line);
        for line in panel.lines.iter().chain(right) {
            if !entries.iter().any(|(name, _)| *name == line.name) {
                entries.push((line.name.clone(), line.color));
            }
        }
    }
    entries
}

fn entries_a_row(width: u32) -> u32 {
    (width / ENTRY_WIDTH).max(1)
}

pub(super) fn rows(entries: usize, width: u32) -> u32 {
    (entries as u32).div_ceil(entries_a_row(width))
}

pub(super) fn draw<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    entries: &[(String, RGBColor)],
) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
    let entries_a_row = entries_a_row(area.dim_in_pixel().0);
    for (index, (name, color)) in (0..).zip(entries) {
        let (row, column) = (index / entries_a_row, index % entries_a_row);
        let x = (column * ENTRY_WIDTH) as i32 + 16;
        let y = (row * LEGEND_ROW_HEIGHT + LEGEND_ROW_HEIGHT / 2) as i32;
        area.draw(&PathElement::new(
            [(x, y), (x + 24, y)],
            color.stroke_width(3),
        ))?;
        let text = Text::new(name.as_str(), (x + 32, y - 7), ("sans-serif", 15));
        area.draw(&text)?;
    }
    Ok(())
}
