//! The band around a line: between which bounds its points may be.

use crate::{Axis, Series};
use plotters::prelude::*;

/// How much a band covers of what is behind it.
const OPACITY: f64 = 0.15;

impl Series {
    /// With a band around the line, from a lower to an upper bound for each point.
    pub fn banded(mut self, bounds: impl IntoIterator<Item = (f64, f64)>) -> Self {
        self.band = bounds.into_iter().collect();
        self
    }

    /// The bounds of the band, each at the point that it belongs to.
    pub(crate) fn bounds(&self) -> impl Iterator<Item = [(f64, f64); 2]> + '_ {
        let bounds = self.points.iter().zip(&self.band);
        bounds.map(|(&(x, _), &(low, high))| [(x, low), (x, high)])
    }

    /// The outline of the band in places, from the lower bounds back along the upper ones; empty without a band.
    pub(crate) fn outline(&self, x: &Axis, y: &Axis) -> Polygon<(f64, f64)> {
        let place = |(a, b): (f64, f64)| (x.place(a), y.place(b));
        let mut bounds: Vec<_> = self.bounds().map(|ends| ends.map(place)).collect();
        bounds.retain(|ends| ends.iter().all(|(a, b)| a.is_finite() && b.is_finite()));
        let lower = bounds.iter().map(|ends| ends[0]);
        let upper = bounds.iter().rev().map(|ends| ends[1]);
        Polygon::new(
            lower.chain(upper).collect::<Vec<_>>(),
            self.color().mix(OPACITY).filled(),
        )
    }
}

#[cfg(test)]
mod tests {
    use crate::{Axis, Chart, Panel, Series, color};

    #[test]
    fn a_band_goes_there_and_back() {
        let series = Series::new("a", color::RED, [(1.0, 10.0), (10.0, 100.0)]);
        assert_eq!(series.bounds().count(), 0);
        let series = series.banded([(1.0, 100.0), (10.0, 1000.0)]);
        let bounds: Vec<_> = series.bounds().flatten().collect();
        let corners = [(1.0, 1.0), (1.0, 100.0), (10.0, 10.0), (10.0, 1000.0)];
        assert_eq!(bounds, corners);

        let panel = Panel::new("b", Axis::log("x"), Axis::log("y"), [series]);
        let file = std::env::temp_dir().join("unisize-charts-band.svg");
        Chart::new("c", [panel]).write_svg(&file).expect("a file");
        let svg = std::fs::read_to_string(&file).expect("the file");
        std::fs::remove_file(file).expect("the file");
        assert!(svg.contains("<polygon"), "{svg}");
        assert!(svg.contains("opacity=\"0.15\""), "{svg}");
    }
}
