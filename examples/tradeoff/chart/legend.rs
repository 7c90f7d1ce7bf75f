//! Which colour a search has in all panels, and the legend below them.

use super::panel::RING;
use crate::method::Search;
use crate::study::Study;
use plotters::coord::Shift;
use plotters::prelude::*;

/// The font size of the legend and of the labels of points.
const FONT: (&str, u32) = ("sans-serif", 15);

/// The widths of its entries.
const ENTRY: i32 = 135;
const LONG_ENTRY: i32 = 270;

/// The colour of a search.
pub(super) fn color(search: Search) -> RGBColor {
    match search {
        Search::GridSweep => RGBColor(213, 0, 0),
        Search::RankSweep => RGBColor(0, 90, 181),
        Search::Rapier => RGBColor(60, 60, 60),
        Search::BruteForce => RGBColor(200, 140, 0),
        Search::CommonBox => RGBColor(0, 130, 80),
    }
}

/// Draws the searches that there are, and what the ring is.
pub(super) fn draw<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    studies: &[&Study],
) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
    let is_there = |search: &Search| studies.iter().any(|study| study.of(*search).count() > 0);
    let (mut x, y) = (16, 16);
    for search in Search::ALL.into_iter().filter(is_there) {
        let style = color(search).stroke_width(2);
        area.draw(&PathElement::new([(x, y), (x + 24, y)], style))?;
        area.draw(&Circle::new((x + 12, y), 4, style.filled()))?;
        area.draw(&Text::new(search.name(), (x + 32, y - 7), FONT))?;
        x += match search {
            Search::CommonBox => LONG_ENTRY,
            _ => ENTRY,
        };
    }
    area.draw(&Circle::new((x + 12, y), RING, BLACK.stroke_width(2)))?;
    area.draw(&Text::new("the default settings", (x + 32, y - 7), FONT))?;
    let explanation = "Points of one colour are margins, in typical sizes of a collider; the one without a number has the \
                       default margin. Equal margins hold equal pairs, whatever the kernel.";
    area.draw(&Text::new(explanation, (16, y + 16), FONT))
}
