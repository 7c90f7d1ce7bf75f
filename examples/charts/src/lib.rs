//! Line charts in SVG with one look: panels in rows, and one legend below them.
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
mod legend;
mod panel;
mod series;

pub use axis::Axis;
pub use panel::Panel;
pub use plotters::style::RGBColor;
pub use series::Series;

use anyhow::{Result, anyhow};
use legend::Legend;
use plotters::prelude::*;
use std::error::Error;
use std::path::{Path, PathBuf};

const PANEL_SIZE: (u32, u32) = (430, 380);

/// A chart with a single panel is wider.
const SINGLE_PANEL_SIZE: (u32, u32) = (860, 420);

const TITLE_HEIGHT: u32 = 40;
const LINE_HEIGHT: u32 = 22;
const TEXT: (&str, u32) = ("sans-serif", 15);

/// A title, panels in rows, and a legend.
#[derive(Clone, Debug)]
pub struct Chart {
    title: String,
    panels: Vec<Panel>,
    columns: usize,
    has_own_ranges: bool,
    notes: Vec<String>,
}

impl Chart {
    /// A chart with all panels in one row. Axes with the same title span the same range in all of them.
    pub fn new(title: impl Into<String>, panels: impl IntoIterator<Item = Panel>) -> Self {
        let panels: Vec<_> = panels.into_iter().collect();
        Self {
            title: title.into(),
            columns: panels.len().max(1),
            panels,
            has_own_ranges: false,
            notes: Vec::new(),
        }
    }

    /// The number of panels in a row.
    pub fn columns(mut self, columns: usize) -> Self {
        self.columns = columns.clamp(1, self.panels.len().max(1));
        self
    }

    /// Every panel gets axes that fit its own values.
    pub fn own_ranges(mut self) -> Self {
        self.has_own_ranges = true;
        self
    }

    /// Adds a line of text below the legend.
    pub fn note(mut self, text: impl Into<String>) -> Self {
        self.notes.push(text.into());
        self
    }

    /// Writes the chart to a file.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write_svg(&self, file: &Path) -> Result<()> {
        self.draw(file)
            .map_err(|error| anyhow!("cannot draw {}: {error}", file.display()))
    }

    fn draw(&self, file: &Path) -> Result<(), Box<dyn Error>> {
        let rows = self.panels.len().div_ceil(self.columns);
        let (panel_width, panel_height) = match self.panels.len() {
            1 => SINGLE_PANEL_SIZE,
            _ => PANEL_SIZE,
        };
        let width = panel_width * self.columns as u32;
        let panels_height = panel_height * rows as u32;
        let legend = Legend::new(&self.panels, width);
        let footer_height = LINE_HEIGHT * (legend.rows() + self.notes.len() as u32) + 10;
        let size = (width, TITLE_HEIGHT + panels_height + footer_height);

        let root = SVGBackend::new(file, size).into_drawing_area();
        root.fill(&WHITE)?;
        let root = root.titled(&self.title, ("sans-serif", 22))?;
        let (upper, lower) = root.split_vertically(panels_height);
        let areas = upper.split_evenly((rows, self.columns));
        for (area, panel) in areas.iter().zip(&self.panels) {
            let sharing = match self.has_own_ranges {
                true => std::slice::from_ref(panel),
                false => &self.panels,
            };
            panel.draw(area, sharing)?;
        }
        legend.draw(&lower)?;
        for (row, note) in (legend.rows()..).zip(&self.notes) {
            lower.draw(&Text::new(note.as_str(), (16, text_top(row)), TEXT))?;
        }
        root.present()?;
        Ok(())
    }
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
