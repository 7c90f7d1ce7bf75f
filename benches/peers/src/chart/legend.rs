//! Which colour and mark a contender has, in all panels, and the legend below them.

use super::LEGEND_ROW_HEIGHT;
use super::panel::Panel;
use plotters::coord::Shift;
use plotters::prelude::*;

/// For what is of this repository.
const OUR_COLORS: [RGBColor; 2] = [RGBColor(213, 0, 0), RGBColor(240, 130, 110)];

/// For all others, such as most can tell apart.
const COLORS: [RGBColor; 10] = [
    RGBColor(0, 90, 181),
    RGBColor(80, 170, 230),
    RGBColor(0, 130, 80),
    RGBColor(110, 200, 130),
    RGBColor(120, 60, 160),
    RGBColor(200, 140, 0),
    RGBColor(60, 60, 60),
    RGBColor(160, 160, 160),
    RGBColor(225, 70, 180),
    RGBColor(240, 160, 215),
];

const ENTRY_WIDTH: u32 = 200;

/// The contenders in the order of the legend.
pub(super) struct Legend<'a>(Vec<&'a str>);

impl<'a> Legend<'a> {
    pub(super) fn new(panels: &'a [Panel<'_>]) -> Self {
        let mut contenders = Vec::new();
        for row in panels.iter().flat_map(|panel| &panel.rows) {
            if !contenders.contains(&&*row.contender) {
                contenders.push(&*row.contender);
            }
        }
        Self(contenders)
    }

    pub(super) fn contenders(&self) -> &[&'a str] {
        &self.0
    }

    /// How the contender with this index is drawn.
    pub(super) fn style(&self, index: usize) -> ShapeStyle {
        let is_ours = |name: &&str| name.starts_with("unisize");
        let ours = self.0.iter().take_while(|name| is_ours(name)).count();
        let color = match index.checked_sub(ours) {
            None => OUR_COLORS[index % OUR_COLORS.len()],
            Some(index) => COLORS[index % COLORS.len()],
        };
        color.stroke_width(if index == 0 { 4 } else { 2 })
    }

    /// The radius of its marks.
    pub(super) fn radius(index: usize) -> i32 {
        if index == 0 { 5 } else { 3 }
    }

    fn entries_a_row(width: u32) -> u32 {
        (width / ENTRY_WIDTH).max(1)
    }

    pub(super) fn rows(&self, width: u32) -> u32 {
        (self.0.len() as u32).div_ceil(Self::entries_a_row(width))
    }

    pub(super) fn draw<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, Shift>,
    ) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
        let entries_a_row = Self::entries_a_row(area.dim_in_pixel().0);
        for (index, contender) in self.0.iter().enumerate() {
            let (row, column) = (index as u32 / entries_a_row, index as u32 % entries_a_row);
            let x = (column * ENTRY_WIDTH) as i32 + 16;
            let y = (row * LEGEND_ROW_HEIGHT + LEGEND_ROW_HEIGHT / 2) as i32;
            let style = self.style(index);
            area.draw(&PathElement::new([(x, y), (x + 24, y)], style))?;
            area.draw(&Circle::new(
                (x + 12, y),
                Self::radius(index),
                style.filled(),
            ))?;
            let text = Text::new(*contender, (x + 32, y - 7), ("sans-serif", 15));
            area.draw(&text)?;
        }
        Ok(())
    }
}
