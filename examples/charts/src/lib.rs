//! Line charts in SVG with one look: panels in rows of two, and one legend below them. All are as wide as a page shows them, so that
//! their text can be read there.
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

const WIDTH: u32 = 860;
const PANEL_HEIGHT: u32 = 380;

const TITLE_HEIGHT: u32 = 40;
const LINE_HEIGHT: u32 = 22;
const TEXT: (&str, u32) = ("sans-serif", 15);

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

    /// Writes the chart to a file.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write_svg(&self, file: &Path) -> Result<()> {
        self.draw(file)
            .map_err(|error| anyhow!("cannot draw {}: {error}", file.display()))
    }

    fn draw(&self, file: &Path) -> Result<(), Box<dyn Error>> {
        let columns = self.panels.len().clamp(1, 2);
        let rows = self.panels.len().div_ceil(columns);
        let panels_height = PANEL_HEIGHT * rows as u32;
        let shown = if self.has_legend {
            &self.panels[..]
        } else {
            &[]
        };
        let legend = Legend::new(shown, WIDTH);
        let footer_height = LINE_HEIGHT * (legend.rows() + self.notes.len() as u32) + 10;
        let size = (WIDTH, TITLE_HEIGHT + panels_height + footer_height);

        let root = SVGBackend::new(file, size).into_drawing_area();
        root.fill(&WHITE)?;
        let root = root.titled(&self.title, ("sans-serif", 22))?;
        let (upper, lower) = root.split_vertically(panels_height);
        let areas = upper.split_evenly((rows, columns));
        for (area, panel) in areas.iter().zip(&self.panels) {
            panel.draw(area, &self.panels)?;
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
