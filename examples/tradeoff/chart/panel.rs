//! One panel: all methods in one scene.

use super::labels::Labels;
use super::{legend, ticks};
use crate::method::{Margin, Method, Search};
use crate::study::{Figures, Study};
use plotters::coord::Shift;
use plotters::coord::combinators::BindKeyPoints;
use plotters::prelude::*;
use std::ops::Range;

/// The radius of the ring around the default settings.
pub(super) const RING: i32 = 8;

/// One scene.
pub(super) struct Panel<'a>(&'a Study);

/// The pairs held for one that touches, and the time.
fn point(figures: &Figures) -> (f64, f64) {
    (figures.held_a_contact(), figures.both)
}

/// From a little below the least figure to a little above the greatest, which is at least `ratio` times that, lest small
/// differences look large.
fn range(figures: impl Iterator<Item = f64>, ratio: f64) -> Range<f64> {
    let wider = |range: Range<f64>, x: f64| range.start.min(x)..range.end.max(x);
    let range = figures.fold(f64::MAX..f64::MIN_POSITIVE, wider);
    let missing = (ratio * range.start / range.end).max(1.0).sqrt();
    // Room for labels.
    let room = missing * (missing * range.end / range.start).powf(0.12);
    range.start / room..range.end * room
}

impl<'a> Panel<'a> {
    pub(super) fn of(study: &'a Study) -> Self {
        Self(study)
    }

    fn points(&self, search: Search) -> Vec<(f64, f64)> {
        self.0.of(search).map(point).collect()
    }

    pub(super) fn draw<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, Shift>,
    ) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
        let study = self.0;
        let points = study.figures.iter().map(point);
        let (held, time) = (
            range(points.clone().map(|(held, _)| held), 1.5),
            range(points.map(|(_, time)| time), 2.0),
        );
        let (held_ticks, time_ticks) = (ticks::of(&held), ticks::of(&time));
        let counts = (held_ticks.len(), time_ticks.len());
        let title = format!("{} {}D, {} bodies", study.scene, study.dim, study.bodies);
        let mut chart = ChartBuilder::on(area)
            .caption(title, ("sans-serif", 17))
            .margin(8)
            .margin_right(18)
            .x_label_area_size(42)
            .y_label_area_size(62)
            .build_cartesian_2d(
                held.log_scale().with_key_points(held_ticks),
                time.log_scale().with_key_points(time_ticks),
            )?;
        chart
            .configure_mesh()
            .light_line_style(WHITE)
            .label_style(("sans-serif", 13))
            .axis_desc_style(("sans-serif", 14))
            .x_desc("pairs held for one that touches")
            .y_desc("broad + narrow phase, ms a step")
            .x_labels(counts.0)
            .y_labels(counts.1)
            .x_label_formatter(&|&tick| ticks::label(tick))
            .y_label_formatter(&|&tick| ticks::label(tick))
            .draw()?;

        // This repository's own fast one last, above all others.
        for search in Search::ALL.into_iter().rev() {
            let points = self.points(search);
            let style = legend::color(search).stroke_width(2);
            chart.draw_series(LineSeries::new(points.iter().copied(), style))?;
            let mark = |&point| Circle::new(point, 4, style.filled());
            chart.draw_series(points.iter().map(mark))?;
        }
        let automatic = point(study.automatic());
        chart.draw_series([Circle::new(automatic, RING, BLACK.stroke_width(2))])?;

        let mut labels = Labels::default();
        let place = |figures: &Figures| chart.backend_coord(&point(figures));
        study.figures.iter().for_each(|f| labels.avoid(place(f), 4));
        labels.avoid(place(study.automatic()), RING);
        for line in Search::ALL.map(|search| self.points(search)) {
            for ends in line.windows(2) {
                labels.avoid_line(chart.backend_coord(&ends[0]), chart.backend_coord(&ends[1]));
            }
        }
        let (x, y) = chart.plotting_area().get_pixel_range();
        let bounds = [x.start, y.start, x.end, y.end];
        let mut texts = Vec::new();
        for figures in &study.figures {
            // The default margin has its ring, and other kernels their point above it.
            let Method { search, margin } = figures.method;
            let has_margins = matches!(search, Search::GridSweep | Search::RankSweep);
            if !has_margins || margin == Margin::Default {
                continue;
            }
            let text = margin.label();
            let offset = labels.place(place(figures), &text, bounds);
            texts.push((point(figures), offset, text, legend::color(search)));
        }
        for (at, offset, text, color) in texts {
            let text = Text::new(text, offset, ("sans-serif", 12).into_font().color(&color));
            chart.draw_series([EmptyElement::at(at) + text])?;
        }
        Ok(())
    }
}
