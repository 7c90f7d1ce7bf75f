//! Line charts in SVG with one look: panels in rows of two, and one legend, below them or in the place of a last panel. All are as wide as
//! a page shows them, so that their text can be read there. The program of this package draws those of `docs/figures` from what is stored in
//! `benches/results`.
//!
//! ```
//! use unisize_charts::{Axis, Chart, Panel, Series, color};
//!
//! let ours = Series::new("unisize", color::RED, [(1e3, 0.2), (1e6, 310.0)]).bold();
//! let theirs = Series::new("others", color::BLUE, [(1e3, 0.4), (1e6, 900.0)]);
//! let panel = Panel::new("2D", Axis::log("n"), Axis::log("milliseconds"), [ours, theirs]);
//! let file = std::env::temp_dir().join("unisize-charts-example.svg");
//! Chart::new("Time per frame", [panel]).write_svg(&file)?;
//! # std::fs::remove_file(file)?;
//! # Ok::<(), anyhow::Error>(())
//! ```
//!
//! An [`Axis`] maps values to *places*, which are what plotters sees: a logarithmic axis is a linear one over logarithms.

mod axis;
pub mod color;
mod labels;
mod mark;
mod panel;
mod series;

pub use axis::Axis;
pub use panel::Panel;
pub use plotters::style::RGBColor;
pub use series::Series;

use anyhow::{Context, Result, anyhow};
use plotters::coord::Shift;
use plotters::prelude::*;
use std::error::Error;
use std::path::{Path, PathBuf};

const WIDTH: u32 = 830;
const PANEL_HEIGHT: u32 = 360;

const TITLE_HEIGHT: u32 = 40;
/// The most that a letter of the legend takes, and the sample of a series with the gaps around it.
const LETTER_WIDTH: u32 = 8;
const SAMPLE_WIDTH: u32 = 56;
const LINE_HEIGHT: u32 = 22;
const TEXT: (&str, u32) = ("sans-serif", 17);

/// A title, panels in rows, and a legend.
#[derive(Clone, Debug)]
pub struct Chart {
    title: String,
    panels: Vec<Panel>,
    has_legend: bool,
    notes: Vec<String>,
}

impl Chart {
    /// A chart of some panels. Axes with the same title span the same range in all of them.
    pub fn new(title: impl Into<String>, panels: impl IntoIterator<Item = Panel>) -> Self {
        Self {
            title: title.into(),
            panels: panels.into_iter().collect(),
            has_legend: true,
            notes: Vec::new(),
        }
    }

    /// Without a legend, where labels say all.
    pub fn without_legend(mut self) -> Self {
        self.has_legend = false;
        self
    }

    /// Adds a line of text below the legend.
    pub fn note(mut self, text: impl Into<String>) -> Self {
        self.notes.push(text.into());
        self
    }

    /// The chart in SVG, which is the same whenever the chart is.
    ///
    /// # Errors
    /// If it cannot be drawn.
    pub fn svg(&self) -> Result<String> {
        let mut svg = String::new();
        self.draw(&mut svg)
            .map_err(|error| anyhow!("cannot draw {:?}: {error}", self.title))?;
        Ok(svg)
    }

    /// Writes the chart to a file.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write_svg(&self, file: &Path) -> Result<()> {
        std::fs::write(file, self.svg()?)
            .with_context(|| format!("cannot write {}", file.display()))
    }

    /// What the legend shows: the first series of every name.
    fn entries(&self) -> Vec<&Series> {
        let mut entries: Vec<&Series> = Vec::new();
        let shown = self.panels.iter().filter(|_| self.has_legend);
        for series in shown.flat_map(|panel| &panel.series) {
            if !entries.iter().any(|entry| entry.name == series.name) {
                entries.push(series);
            }
        }
        entries
    }

    fn draw(&self, svg: &mut String) -> Result<(), Box<dyn Error>> {
        let columns = self.panels.len().clamp(1, 2);
        let rows = self.panels.len().div_ceil(columns);
        let panels_height = PANEL_HEIGHT * rows as u32;
        let entries = self.entries();
        // Three panels leave the place of a fourth one free.
        let free =
            (self.panels.len() % 2 == 1 && self.panels.len() > 1).then_some(self.panels.len());
        let lengths = entries.iter().map(|entry| entry.name.chars().count());
        let entry_width = LETTER_WIDTH * lengths.max().unwrap_or(0) as u32 + SAMPLE_WIDTH;
        let entries_in_row = match free {
            None => (WIDTH / entry_width).max(1),
            Some(_) => 1,
        };
        let legend_rows = match free {
            None => (entries.len() as u32).div_ceil(entries_in_row),
            Some(_) => 0,
        };
        let footer_height = LINE_HEIGHT * (legend_rows + self.notes.len() as u32) + 10;
        let size = (WIDTH, TITLE_HEIGHT + panels_height + footer_height);

        let root = SVGBackend::with_string(svg, size).into_drawing_area();
        root.fill(&WHITE)?;
        let root = root.titled(&self.title, ("sans-serif", 22))?;
        let (upper, lower) = root.split_vertically(panels_height);
        let areas = upper.split_evenly((rows, columns));
        for (area, panel) in areas.iter().zip(&self.panels) {
            panel.draw(area, &self.panels)?;
        }
        let (legend, left, top) = match free {
            None => (&lower, 16, 0),
            Some(index) => (&areas[index], 64, 2),
        };
        for (index, entry) in (0..).zip(entries) {
            let (row, column) = (index / entries_in_row, index % entries_in_row);
            let x = (column * entry_width) as i32 + left;
            draw_entry(legend, entry, row + top, x)?;
        }
        for (row, note) in (legend_rows..).zip(&self.notes) {
            lower.draw(&Text::new(note.as_str(), (16, text_top(row)), TEXT))?;
        }
        root.present()?;
        Ok(())
    }
}

/// Draws a series of the legend in a row below the panels, from this place on: a sample, and its name.
fn draw_entry<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    entry: &Series,
    row: u32,
    x: i32,
) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
    let y = (row * LINE_HEIGHT + LINE_HEIGHT / 2) as i32;
    let sample = [(x, y), (x + 24, y)];
    area.draw(&PathElement::new(sample, entry.line_style()))?;
    if entry.has_marks() {
        area.draw(&entry.mark((x + 12, y)))?;
    }
    area.draw(&Text::new(
        entry.name.as_str(),
        (x + 32, text_top(row)),
        TEXT,
    ))
}

/// The upper edge of the text in a row below the panels.
fn text_top(row: u32) -> i32 {
    (row * LINE_HEIGHT + 4) as i32
}

/// Where a program writes its charts in a quick run, whose figures are too rough to publish: a folder of this name in
/// Cargo's target directory.
pub fn scratch_folder(name: &str) -> PathBuf {
    let target = std::env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into());
    Path::new(&target).join(name)
}
