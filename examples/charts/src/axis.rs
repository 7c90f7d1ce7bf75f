//! An axis: its title, its range, and its ticks.

use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint, Ranged};
use std::ops::Range;

/// An axis, either linear from zero on or logarithmic.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    pub(crate) title: String,
    is_log: bool,
    /// The band that stands for zero on a logarithmic axis, as the values that would be at its ends.
    zero: Option<[f64; 2]>,
}

/// A logarithmic axis spans at least this factor, lest small differences look large.
const LEAST_FACTOR: f64 = 2.0;

/// The part of the span that is added at an end, so that marks and labels have room.
const ROOM: f64 = 0.08;

/// A logarithmic axis is short if it spans less than this factor. Its ticks are at even steps.
const SHORT: f64 = 10.0;

/// Fewer ticks say too little about an axis with even steps, and about one with powers of ten.
const FEW: usize = 4;
const FEW_POWERS: usize = 3;

impl Axis {
    /// From zero on; values below zero are not shown.
    pub fn linear(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            is_log: false,
            zero: None,
        }
    }

    /// Logarithmic; values that are not above zero are not shown, unless [zero has a place](Self::with_zero_between).
    pub fn log(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            is_log: true,
            zero: None,
        }
    }

    /// With a shaded band for zero, labelled "none", on a logarithmic axis: between these two values, which must be less than
    /// all others. Zero itself is in the middle. What is zero too may be given a value in the band, so that it does not cover
    /// the rest.
    pub fn with_zero_between(mut self, from: f64, to: f64) -> Self {
        self.zero = Some([from, to]);
        self
    }

    /// The places of the two ends of the band for zero, if there is one.
    pub(crate) fn zero_band(&self) -> Option<[f64; 2]> {
        self.zero.map(|ends| ends.map(f64::log10))
    }

    /// Where zero is if it has a place.
    fn zero_place(&self) -> Option<f64> {
        self.zero_band().map(|[from, to]| (from + to) / 2.0)
    }

    /// Where a value is along the axis: its logarithm to base 10, or itself.
    pub(crate) fn place(&self, value: f64) -> f64 {
        match self.zero_place() {
            Some(zero) if value == 0.0 => zero,
            _ if self.is_log => value.log10(),
            _ => value,
        }
    }

    fn value(&self, place: f64) -> f64 {
        if self.is_log {
            10_f64.powf(place)
        } else {
            place
        }
    }

    /// Its range and ticks for these values.
    pub(crate) fn scale(&self, values: impl Iterator<Item = f64>) -> Scale {
        let range = self.range(values);
        Scale {
            ticks: self.ticks(&range),
            range,
        }
    }

    /// The places that the axis spans for these values, with some room around them.
    fn range(&self, values: impl Iterator<Item = f64>) -> Range<f64> {
        let places = values.map(|value| self.place(value));
        let places = places.chain(self.zero_band().into_iter().flatten());
        let wider = |(low, high): (f64, f64), x: f64| (low.min(x), high.max(x));
        let finite = places.filter(|x| x.is_finite());
        let (low, high) = finite.fold((f64::MAX, f64::MIN), wider);
        if low > high {
            return 0.0..1.0;
        }
        if !self.is_log {
            return 0.0..if high > 0.0 { high * (1.0 + ROOM) } else { 1.0 };
        }
        let span = (high - low).max(LEAST_FACTOR.log10());
        let room = (span - (high - low)) / 2.0 + ROOM * span;
        low - room..high + room
    }

    /// The places of the ticks: as coarse as will do.
    fn ticks(&self, range: &Range<f64>) -> Vec<f64> {
        let [low, high] = [range.start, range.end].map(|place| self.value(place));
        let (candidates, few): (Vec<Vec<f64>>, _) = if self.is_log && high >= SHORT * low {
            let powers = range.start.floor() as i32..=range.end.ceil() as i32;
            let by_digits = [&[1.0][..], &[1.0, 2.0, 5.0]].map(|digits| {
                let of_power = |power| digits.iter().map(move |digit| digit * 10_f64.powi(power));
                powers.clone().flat_map(of_power).collect()
            });
            (by_digits.into(), FEW_POWERS)
        } else {
            let power = (high - low).log10().ceil() as i32;
            let digits = [50.0, 20.0, 10.0, 5.0, 2.0, 1.0];
            let by_steps = digits.map(|digit| {
                let step = digit * 10_f64.powi(power - 2);
                let numbers = (low / step).ceil() as i64..=(high / step).floor() as i64;
                numbers.map(|number| number as f64 * step).collect()
            });
            (by_steps.into(), FEW)
        };
        let mut candidates = candidates.into_iter().map(|ticks| {
            let places = ticks.into_iter().map(|tick| self.place(tick));
            places.filter(|place| range.contains(place)).collect()
        });
        let mut ticks: Vec<f64> = candidates.next().unwrap_or_default();
        while ticks.len() < few {
            let Some(finer) = candidates.next() else {
                break;
            };
            ticks = finer;
        }
        if let (Some([_, end]), Some(zero)) = (self.zero_band(), self.zero_place()) {
            ticks.retain(|&place| place > end);
            ticks.insert(0, zero);
        }
        ticks
    }

    /// The value at a tick, without the noise of its last bits.
    pub(crate) fn label(&self, place: f64) -> String {
        if self.zero_place() == Some(place) {
            return "none".to_owned();
        }
        // Logarithms are not exact: what is just below a power of ten is one.
        let value = self.value(place) * (1.0 + 1e-9);
        let (value, unit) = match value {
            value if value >= 1e6 => (value / 1e6, " M"),
            value if value >= 1e4 => (value / 1e3, " k"),
            value => (value, ""),
        };
        let decimals = (2.0 - value.log10().floor()).clamp(0.0, 9.0) as usize;
        let mut text = format!("{value:.decimals$}");
        if text.contains('.') {
            text.truncate(text.trim_end_matches('0').trim_end_matches('.').len());
        }
        text + unit
    }
}

/// The places that an axis spans, and those of its ticks.
#[derive(Clone, Debug)]
pub(crate) struct Scale {
    range: Range<f64>,
    ticks: Vec<f64>,
}

impl Ranged for Scale {
    type FormatOption = DefaultFormatting;
    type ValueType = f64;

    fn map(&self, place: &f64, (low, high): (i32, i32)) -> i32 {
        let share = (place - self.range.start) / (self.range.end - self.range.start);
        low + (f64::from(high - low) * share).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks.clone()
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::Axis;

    fn labels(axis: &Axis, values: [f64; 2]) -> Vec<String> {
        let range = axis.range(values.into_iter());
        let ticks = axis.ticks(&range);
        ticks.iter().map(|&tick| axis.label(tick)).collect()
    }

    #[test]
    fn labels_are_round() {
        let log = Axis::log("x");
        let expected = ["1000", "2000", "5000", "10 k", "20 k"];
        assert_eq!(labels(&log, [900.0, 30_000.0]), expected);
        let expected = ["1", "10", "100", "1000"];
        assert_eq!(labels(&log, [0.95, 1100.0]), expected);
        assert_eq!(labels(&log, [8e3, 2e6]), ["10 k", "100 k", "1 M"]);
        let linear = Axis::linear("y");
        assert_eq!(labels(&linear, [0.3, 9.0]), ["0", "2", "4", "6", "8"]);
    }

    #[test]
    fn numbers_are_short() {
        let numbers = [0.0, 0.000_25, 0.02, 1.5, 30.000_000_001, 1000.0, 12_500.0];
        let labels = numbers.map(|number| Axis::linear("y").label(number));
        assert_eq!(
            labels,
            ["0", "0.00025", "0.02", "1.5", "30", "1000", "12.5 k"]
        );
    }

    #[test]
    fn short_axes_have_ticks_too() {
        let axis = Axis::log("x");
        for [low, high] in [
            [1.05, 2.1_f64],
            [0.9, 3.0],
            [0.0021, 0.0029],
            [3.0, 20.0],
            [95.0, 105.0],
        ] {
            let range = low.log10()..high.log10();
            let ticks = axis.ticks(&range);
            assert!((4..12).contains(&ticks.len()), "{range:?}: {ticks:?}");
        }
    }

    #[test]
    fn zero_may_have_a_place_on_a_logarithmic_axis() {
        let axis = Axis::log("x").with_zero_between(1e-5, 1e-3);
        assert_eq!(axis.place(0.0), -4.0);
        assert_eq!(axis.place(0.01), -2.0);
        assert_eq!(labels(&axis, [0.0, 0.2]), ["none", "0.01", "0.1"]);
        assert!(axis.range([0.5].into_iter()).contains(&-5.0));
        assert!(Axis::log("x").place(0.0).is_infinite());
    }

    #[test]
    fn there_is_a_range_for_all_values() {
        let log = Axis::log("x");
        assert_eq!(log.range(std::iter::empty()), 0.0..1.0);
        assert_eq!(Axis::linear("x").range([0.0].into_iter()), 0.0..1.0);
        assert_eq!(labels(&Axis::linear("x"), [0.0; 2]).len(), 5);
        // One value, and one that has no logarithm.
        let range = log.range([5.0, 0.0].into_iter());
        assert!(range.end - range.start > 0.3);
        assert!(range.contains(&5_f64.log10()));
    }
}
