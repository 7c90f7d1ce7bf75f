//! An axis: what it says, how far it reaches, and where it has labels.

use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint, Ranged};
use std::ops::Range;

/// An axis, which is linear from zero or logarithmic.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Axis {
    pub(crate) title: &'static str,
    is_log: bool,
}

impl Axis {
    /// From zero on.
    pub(crate) fn linear(title: &'static str) -> Self {
        Self {
            title,
            is_log: false,
        }
    }

    pub(crate) fn log(title: &'static str) -> Self {
        Self {
            title,
            is_log: true,
        }
    }

    /// Where a value is along the axis: its logarithm to base 10, or itself.
    pub(super) fn place(&self, value: f64) -> f64 {
        if self.is_log { value.log10() } else { value }
    }

    /// The places that the axis spans for these values, some room included.
    fn range(&self, values: impl Iterator<Item = f64>) -> Range<f64> {
        let places = values.map(|value| self.place(value));
        let wider = |(low, high): (f64, f64), x: f64| (low.min(x), high.max(x));
        let finite = places.filter(|x| x.is_finite());
        let (low, high) = finite.fold((f64::MAX, f64::MIN), wider);
        match (self.is_log, low <= high) {
            (_, false) => 0.0..1.0,
            (true, _) => low - 0.12..high + 0.12,
            (false, _) => 0.0..(high * 1.06).max(f64::MIN_POSITIVE),
        }
    }

    /// The places that have labels.
    fn ticks(&self, range: &Range<f64>) -> Vec<f64> {
        let powers = range.start.floor() as i32..=range.end.ceil() as i32;
        if !self.is_log {
            let step = step(range.end);
            let last = (range.end / step) as usize;
            return (0..=last).map(|i| i as f64 * step).collect();
        }
        let digits: &[f64] = match range.end - range.start {
            span if span > 3.0 => &[1.0],
            _ => &[1.0, 2.0, 5.0],
        };
        let ticks =
            powers.flat_map(|power| digits.iter().map(move |d| d.log10() + f64::from(power)));
        ticks.filter(|tick| range.contains(tick)).collect()
    }

    /// What is written at a place.
    pub(super) fn label(&self, place: f64) -> String {
        let value = if self.is_log {
            10_f64.powf(place)
        } else {
            place
        };
        match value {
            // Rid of what rounding left.
            value if value >= 1e6 => format!("{} M", (value / 1e4).round() / 100.0),
            value if value >= 1e4 => format!("{} k", (value / 1e1).round() / 100.0),
            value => format!("{}", (value * 1e4).round() / 1e4),
        }
    }
}

/// The span of an axis, with its ticks: what plotters asks for.
#[derive(Clone, Debug)]
pub(super) struct Scale {
    range: Range<f64>,
    ticks: Vec<f64>,
}

impl Scale {
    /// That of an axis for these values.
    pub(super) fn of(axis: &Axis, values: impl Iterator<Item = f64>) -> Self {
        let range = axis.range(values);
        Self {
            ticks: axis.ticks(&range),
            range,
        }
    }
}

impl Ranged for Scale {
    type FormatOption = DefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (low, high): (i32, i32)) -> i32 {
        let share = (value - self.range.start) / (self.range.end - self.range.start);
        low + (f64::from(high - low) * share).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks.clone()
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

/// A round number of which four to nine reach this far.
fn step(end: f64) -> f64 {
    let power = 10_f64.powf((end / 4.0).log10().floor());
    let steps = [5.0, 2.0, 1.0].map(|digit| digit * power);
    let fits = |step: &f64| end / step >= 4.0;
    steps.into_iter().find(fits).unwrap_or(power)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_round() {
        let axis = Axis::log("x");
        let range = axis.range([900.0, 30_000.0].into_iter());
        let labels: Vec<_> = axis.ticks(&range).iter().map(|&x| axis.label(x)).collect();
        assert_eq!(labels, ["1000", "2000", "5000", "10 k", "20 k"]);
        let axis = Axis::linear("y");
        let range = axis.range([0.3, 9.0].into_iter());
        let labels: Vec<_> = axis.ticks(&range).iter().map(|&x| axis.label(x)).collect();
        assert_eq!(labels, ["0", "2", "4", "6", "8"]);
    }

    #[test]
    fn there_is_a_range_without_values() {
        assert_eq!(Axis::log("x").range(std::iter::empty()), 0.0..1.0);
        assert!(Axis::linear("x").range([0.0].into_iter()).end > 0.0);
    }
}
