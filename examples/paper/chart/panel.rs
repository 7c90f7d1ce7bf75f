//! One panel.

use super::axis::{Axis, Scale};
use super::{Line, Panel};
use plotters::coord::Shift;
use plotters::prelude::*;

/// With more points than this, a line has no marks.
const MARKED: usize = 40;

impl Panel {
    /// Draws the panel with the range that its axes have in all panels.
    pub(super) fn draw<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, Shift>,
        all: &[Self],
    ) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
        let with_same_x = all.iter().filter(|panel| panel.x == self.x);
        let with_same_y = all.iter().filter(|panel| panel.y == self.y);
        let xs = with_same_x.flat_map(|panel| values(&panel.lines, |point| point.0));
        let ys = with_same_y.flat_map(|panel| values(&panel.lines, |point| point.1));
        let (x, y) = (Scale::of(&self.x, xs), Scale::of(&self.y, ys));
        // The type of a chart says whether it has a second axis, so there is one in any case.
        let second = match &self.right {
            Some((axis, line)) => Scale::of(axis, line.points.iter().map(|point| point.1)),
            None => y.clone(),
        };

        let mut builder = ChartBuilder::on(area);
        builder
            .caption(&self.title, ("sans-serif", 17))
            .margin(8)
            .margin_right(18)
            .x_label_area_size(42)
            .y_label_area_size(58);
        if self.right.is_some() {
            builder.right_y_label_area_size(62);
        }
        let mut chart = builder
            .build_cartesian_2d(x.clone(), y)?
            .set_secondary_coord(x, second);
        chart
            .configure_mesh()
            .light_line_style(WHITE)
            .label_style(("sans-serif", 13))
            .axis_desc_style(("sans-serif", 14))
            .x_desc(self.x.title)
            .y_desc(self.y.title)
            .x_label_formatter(&|&place| self.x.label(place))
            .y_label_formatter(&|&place| self.y.label(place))
            .draw()?;
        if let Some((axis, line)) = &self.right {
            chart
                .configure_secondary_axes()
                .label_style(("sans-serif", 13))
                .axis_desc_style(("sans-serif", 14))
                .y_desc(axis.title)
                .y_label_formatter(&|&place| axis.label(place))
                .draw()?;
            let points = places(line, &self.x, axis);
            chart.draw_secondary_series(LineSeries::new(points, line.color.stroke_width(2)))?;
        }
        for line in &self.lines {
            let points = places(line, &self.x, &self.y);
            let style = line.color.stroke_width(2);
            chart.draw_series(LineSeries::new(points.iter().copied(), style))?;
            if points.len() <= MARKED {
                let mark = |&point| Circle::new(point, 3, line.color.filled());
                chart.draw_series(points.iter().map(mark))?;
            }
        }
        Ok(())
    }
}

fn values(lines: &[Line], of: fn(&(f64, f64)) -> f64) -> impl Iterator<Item = f64> {
    lines
        .iter()
        .flat_map(move |line| line.points.iter().map(of))
}

/// Where the points of a line are; those that have no place on a logarithmic axis are left out.
fn places(line: &Line, x: &Axis, y: &Axis) -> Vec<(f64, f64)> {
    let place = |&(a, b): &(f64, f64)| (x.place(a), y.place(b));
    let points = line.points.iter().map(place);
    points
        .filter(|(a, b)| a.is_finite() && b.is_finite())
        .collect()
}
