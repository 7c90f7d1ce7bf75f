//! One panel: all contenders in one case, at every number of boxes.

use super::legend::Legend;
use crate::row::Row;
use plotters::coord::Shift;
use plotters::prelude::*;
use std::collections::BTreeSet;
use std::ops::Range;

/// The rows of a case.
pub(super) struct Panel<'a> {
    title: String,
    pub(super) rows: Vec<&'a Row>,
}

/// A panel for each case, those of a dimension side by side. Of its densities, the higher one is drawn: the
/// other one is in the table, and so are sizes that differ. Cases of few numbers of boxes make no line.
pub(super) fn of_rows<'a>(rows: &[&'a Row]) -> Vec<Panel<'a>> {
    let mut panels = Vec::new();
    for case in rows.chunk_by(|a, b| a.is_in_series_with(b)) {
        let Some(first) = case.first() else { continue };
        let counts: BTreeSet<_> = case.iter().map(|row| row.count).collect();
        let is_densest = rows
            .iter()
            .all(|row| row.dimension != first.dimension || row.density <= first.density);
        if is_densest && counts.len() > 2 {
            let motion = if first.motion.is_empty() {
                String::new()
            } else {
                format!(", {}", first.motion)
            };
            panels.push(Panel {
                title: format!("{}D, density {}{motion}", first.dimension, first.density),
                rows: case.to_vec(),
            });
        }
    }
    panels
}

/// As many panels side by side as there are of one dimension, if that is more than one.
pub(super) fn columns(panels: &[Panel<'_>]) -> usize {
    let dimension = |panel: &Panel<'_>| panel.rows[0].dimension;
    let first = panels
        .iter()
        .take_while(|p| dimension(p) == dimension(&panels[0]));
    match first.count() {
        1 => panels.len(),
        columns => columns,
    }
}

/// The axes that all panels share.
pub(super) struct Ranges {
    count: Range<f64>,
    time: Range<f64>,
}

impl Ranges {
    /// From a little below the least figure to a little above the greatest.
    pub(super) fn of(panels: &[Panel<'_>]) -> Self {
        let around = |figure: fn(&Row) -> f64| {
            let figures = panels.iter().flat_map(|p| &p.rows).map(|row| figure(row));
            let wider = |range: Range<f64>, x: f64| range.start.min(x)..range.end.max(x);
            let range = figures.fold(f64::MAX..f64::MIN_POSITIVE, wider);
            range.start / 1.4..range.end * 1.4
        };
        Self {
            count: around(|row| row.count as f64),
            time: around(nanoseconds_a_box),
        }
    }
}

fn nanoseconds_a_box(row: &Row) -> f64 {
    row.time_ms() * 1e6 / row.count as f64
}

impl Panel<'_> {
    pub(super) fn draw<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, Shift>,
        legend: &Legend,
        ranges: &Ranges,
    ) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
        let mut chart = ChartBuilder::on(area)
            .caption(&self.title, ("sans-serif", 17))
            .margin(8)
            .margin_right(18)
            .x_label_area_size(42)
            .y_label_area_size(58)
            .build_cartesian_2d(
                ranges.count.clone().log_scale(),
                ranges.time.clone().log_scale(),
            )?;
        chart
            .configure_mesh()
            .light_line_style(WHITE)
            .label_style(("sans-serif", 13))
            .axis_desc_style(("sans-serif", 14))
            .x_desc("n")
            .y_desc("nanoseconds a box")
            .x_label_formatter(&|&count| label(count, &[1]))
            .y_label_formatter(&|&time| label(time, &[1, 2, 5]))
            .draw()?;
        // This repository's own last, above all others.
        for (index, contender) in legend.contenders().iter().enumerate().rev() {
            let rows = self.rows.iter().filter(|row| row.contender == *contender);
            let points: Vec<_> = rows
                .map(|row| (row.count as f64, nanoseconds_a_box(row)))
                .collect();
            let style = legend.style(index);
            chart.draw_series(LineSeries::new(points.iter().copied(), style))?;
            let mark = |&point| Circle::new(point, Legend::radius(index), style.filled());
            chart.draw_series(points.iter().map(mark))?;
        }
        Ok(())
    }
}

/// A number in full, with commas, if it is one of these digits and zeros: others have no room.
fn label(number: f64, digits: &[u32]) -> String {
    let text = format!("{number}");
    let significant = text.trim_matches(['0', '.']);
    if !digits.iter().any(|digit| significant == digit.to_string()) {
        return String::new();
    }
    if number < 1000.0 {
        return text;
    }
    let mut with_commas = String::new();
    for (i, digit) in text.chars().enumerate() {
        if i > 0 && (text.len() - i) % 3 == 0 {
            with_commas.push(',');
        }
        with_commas.push(digit);
    }
    with_commas
}

#[cfg(test)]
mod tests {
    use super::label;

    #[test]
    fn round_numbers_have_labels_and_others_have_none() {
        assert_eq!(label(1e6, &[1]), "1,000,000");
        assert_eq!(label(200.0, &[1, 2]), "200");
        assert_eq!(label(0.5, &[5]), "0.5");
        assert_eq!(label(2e4, &[1]), "");
        assert_eq!(label(1200.0, &[1, 2]), "");
    }
}
