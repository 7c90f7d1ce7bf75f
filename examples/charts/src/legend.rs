//! The legend below the panels: each name once.

use crate::{LINE_HEIGHT, Panel, Series, TEXT, text_top};
use plotters::coord::Shift;
use plotters::prelude::*;

/// About the width of a letter, and that of everything else in an entry.
const LETTER_WIDTH: u32 = 8;
const SAMPLE_WIDTH: u32 = 56;

/// The first series of every name, in columns.
pub(crate) struct Legend<'a> {
    entries: Vec<&'a Series>,
    entry_width: u32,
    columns: u32,
}

impl<'a> Legend<'a> {
    pub(crate) fn new(panels: &'a [Panel], width: u32) -> Self {
        let mut entries: Vec<&Series> = Vec::new();
        for series in panels.iter().flat_map(|panel| &panel.series) {
            if !entries.iter().any(|entry| entry.name == series.name) {
                entries.push(series);
            }
        }
        let lengths = entries.iter().map(|entry| entry.name.chars().count());
        let entry_width = LETTER_WIDTH * lengths.max().unwrap_or(0) as u32 + SAMPLE_WIDTH;
        Self {
            entries,
            entry_width,
            columns: (width / entry_width).max(1),
        }
    }

    pub(crate) fn rows(&self) -> u32 {
        (self.entries.len() as u32).div_ceil(self.columns)
    }

    pub(crate) fn draw<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, Shift>,
    ) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
        for (index, entry) in (0..).zip(&self.entries) {
            let (row, column) = (index / self.columns, index % self.columns);
            let x = (column * self.entry_width) as i32 + 16;
            let y = (row * LINE_HEIGHT + LINE_HEIGHT / 2) as i32;
            if entry.has_line() {
                let sample = [(x, y), (x + 24, y)];
                area.draw(&PathElement::new(sample, entry.line_style()))?;
            }
            let center = (x + 12, y);
            if entry.has_marks() {
                area.draw(&entry.mark(center))?;
            }
            area.draw(&Text::new(
                entry.name.as_str(),
                (x + 32, text_top(row)),
                TEXT,
            ))?;
        }
        Ok(())
    }
}
