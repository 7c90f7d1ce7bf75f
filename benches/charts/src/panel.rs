//! One panel: series over two axes.

use crate::axis::Scale;
use crate::labels::Labels;
use crate::{Axis, Series};
use plotters::coord::Shift;
use plotters::prelude::*;

const CAPTION: (&str, u32) = ("sans-serif", 17);
const AXIS_TITLE: (&str, u32) = ("sans-serif", 16);
const TICK: (&str, u32) = ("sans-serif", 15);
const POINT_LABEL: (&str, u32) = ("sans-serif", 15);

/// How dark the band is that stands for zero.
const ZERO_SHADE: f64 = 0.06;

/// Series over two axes.
#[derive(Clone, Debug)]
pub struct Panel {
    title: String,
    x: Axis,
    y: Axis,
    pub(crate) series: Vec<Series>,
}

impl Panel {
    /// A panel; the first series is drawn last, above all others.
    pub fn new(
        title: impl Into<String>,
        x: Axis,
        y: Axis,
        series: impl IntoIterator<Item = Series>,
    ) -> Self {
        Self {
            title: title.into(),
            x,
            y,
            series: series.into_iter().collect(),
        }
    }

    /// Draws the panel. Its axes span the values of all panels that have the same axis.
    pub(crate) fn draw<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, Shift>,
        all: &[Self],
    ) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
        let xs = all.iter().filter(|panel| panel.x == self.x);
        let ys = all.iter().filter(|panel| panel.y == self.y);
        let x = self.x.scale(xs.flat_map(points_of).map(|(x, _)| x));
        let y = self.y.scale(ys.flat_map(points_of).map(|(_, y)| y));
        let mut builder = ChartBuilder::on(area);
        if !self.title.is_empty() {
            builder.caption(&self.title, CAPTION);
        }
        let mut chart = builder
            .margin(8)
            .margin_right(18)
            .x_label_area_size(46)
            .y_label_area_size(64)
            .build_cartesian_2d(x.clone(), y.clone())?;
        chart
            .configure_mesh()
            .light_line_style(WHITE)
            .label_style(TICK)
            .axis_desc_style(AXIS_TITLE)
            .x_desc(&self.x.title)
            .y_desc(&self.y.title)
            .x_label_formatter(&|&place| x.label(place))
            .y_label_formatter(&|&place| y.label(place))
            .draw()?;
        if let Some(end) = x.end_of_zero() {
            let [xs, ys] = [chart.x_range(), chart.y_range()];
            let corners = [(xs.start, ys.start), (end, ys.end)];
            let shade = BLACK.mix(ZERO_SHADE).filled();
            chart.draw_series([Rectangle::new(corners, shade)])?;
            let word = Text::new(self.x.zero.clone(), (6, -20), POINT_LABEL);
            let corner = EmptyElement::at((xs.start, ys.start));
            chart.draw_series([corner + word])?;
        }
        let mut labels = Labels::default();
        let mut texts = Vec::new();
        for series in self.series.iter().rev() {
            let places: Vec<_> = places(series, &x, &y).collect();
            chart.draw_series(LineSeries::new(places.clone(), series.line_style()))?;
            if series.has_marks() {
                chart.draw_series(places.iter().map(|&place| series.mark(place)))?;
            }
            for place in places {
                let pixel = chart.backend_coord(&place);
                labels.avoid(pixel, series.radius);
                if series.is_labelled {
                    texts.push((place, series.name.clone(), pixel));
                }
            }
        }
        let (xs, ys) = chart.plotting_area().get_pixel_range();
        let bounds = [xs.start, ys.start, xs.end, ys.end];
        for (place, label, at) in texts {
            let offset = labels.place(at, &label, bounds);
            let text = Text::new(label, offset, POINT_LABEL);
            chart.draw_series([EmptyElement::at(place) + text])?;
        }
        Ok(())
    }
}

/// Where the points of a series are. Those without a place on a logarithmic axis are left out.
fn places<'a>(
    series: &'a Series,
    x: &'a Scale,
    y: &'a Scale,
) -> impl Iterator<Item = (f64, f64)> + 'a {
    let places = series.points.iter().map(|&(a, b)| (x.place(a), y.place(b)));
    places.filter(|(a, b)| a.is_finite() && b.is_finite())
}

fn points_of(panel: &Panel) -> impl Iterator<Item = (f64, f64)> {
    let series = panel.series.iter();
    series.flat_map(|series| series.points.iter().copied())
}
