//! The charts in SVG: what each method holds beyond what touches, against what it costs; a panel for each scene.

use crate::method::{Margin, Method, Search};
use crate::study::{Figures, Study};
use anyhow::Result;
use std::path::Path;
use unisize_charts::{Axis, Chart, Panel, RGBColor, Series, color};

const COLUMNS: usize = 3;

/// Draws the studies of one dimension.
pub(crate) fn draw(file: &Path, dim: u8, studies: &[&Study]) -> Result<()> {
    let title = format!("What a margin costs, {dim}D: left is precise, low is fast");
    Chart::new(title, studies.iter().map(|study| panel(study)))
        .columns(COLUMNS)
        .own_ranges()
        .note("Each line runs over margins, labelled in typical collider sizes; the point without a label has the default margin.")
        .note("Equal margins hold equal pairs, whatever the kernel.")
        .write_svg(file)
}

/// All methods in one scene.
fn panel(study: &Study) -> Panel {
    let of_search = |&search: &Search| {
        let figures: Vec<_> = study.of(search).collect();
        let series = Series::new(
            search.name(),
            color(search),
            figures.iter().copied().map(point),
        );
        (!figures.is_empty()).then(|| series.labelled(figures.into_iter().map(label)))
    };
    let default = [point(study.automatic())];
    let default = Series::new("the default settings", color::BLACK, default).ringed();
    Panel::new(
        format!("{} {}D, {} bodies", study.scene, study.dim, study.bodies),
        Axis::log("pairs held per touching pair"),
        Axis::log("broad + narrow phase, ms per step"),
        Search::ALL.iter().filter_map(of_search).chain([default]),
    )
}

/// The pairs held per touching pair, and the time.
fn point(figures: &Figures) -> (f64, f64) {
    (figures.held_a_contact(), figures.both)
}

/// The margin, where a method has several. The default margin goes without: the ring marks it on GridSweep's line, and
/// RankSweep's point lies above.
fn label(figures: &Figures) -> String {
    let Method { search, margin } = figures.method;
    match search {
        Search::GridSweep | Search::RankSweep if margin != Margin::Default => margin.label(),
        _ => String::new(),
    }
}

fn color(search: Search) -> RGBColor {
    match search {
        Search::GridSweep => color::RED,
        Search::RankSweep => color::SALMON,
        Search::Rapier => color::BLUE,
        Search::BruteForce => color::OCHRE,
        Search::CommonBox => color::GREEN,
    }
}
