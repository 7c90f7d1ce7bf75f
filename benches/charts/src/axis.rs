//! An axis: its title, and for the values along it its range and its ticks.

use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint, Ranged};
use std::ops::Range;

/// An axis, either linear from zero on or logarithmic.
///
/// Values below zero are not shown. Zero has a place of its own on a logarithmic axis, a shaded band below all other values.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    pub(crate) title: String,
    /// What stands in the band of zero.
    pub(crate) zero: String,
    is_log: bool,
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

/// How far zero is below the least of the other values, and how wide its band is, in powers of ten.
const ZERO_BELOW: f64 = 1.1;
const ZERO_WIDTH: f64 = 0.8;

impl Axis {
    /// From zero on.
    pub fn linear(title: impl Into<String>) -> Self {
        Self {
            is_log: false,
            ..Self::log(title)
        }
    }

    /// Logarithmic.
    pub fn log(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            zero: String::new(),
            is_log: true,
        }
    }

    /// With a word for zero, which stands in its band. It is for horizontal axes.
    pub fn with_zero(mut self, word: impl Into<String>) -> Self {
        self.zero = word.into();
        self
    }

    /// Its range and ticks for these values.
    pub(crate) fn scale(&self, values: impl Iterator<Item = f64>) -> Scale {
        let values: Vec<_> = values.filter(|value| value.is_finite()).collect();
        let mut scale = Scale {
            is_log: self.is_log,
            zero: None,
            range: 0.0..1.0,
            ticks: Vec::new(),
        };
        let place = |value: &f64| scale.place(*value);
        let places = values.iter().map(place).filter(|place| place.is_finite());
        let wider = |(low, high): (f64, f64), x: f64| (low.min(x), high.max(x));
        let (mut low, high) = places.fold((f64::MAX, f64::MIN), wider);
        if low <= high {
            if self.is_log && values.contains(&0.0) {
                scale.zero = Some(low - ZERO_BELOW);
                low -= ZERO_BELOW + ZERO_WIDTH / 2.0;
            }
            scale.range = self.range(low, high);
        }
        scale.ticks = scale.ticks();
        scale
    }

    /// From the lowest to the highest place, with some room around them.
    fn range(&self, low: f64, high: f64) -> Range<f64> {
        if !self.is_log {
            return 0.0..if high > 0.0 { high * (1.0 + ROOM) } else { 1.0 };
        }
        let span = (high - low).max(LEAST_FACTOR.log10());
        let room = (span - (high - low)) / 2.0 + ROOM * span;
        low - room..high + room
    }
}

/// The places that an axis spans, and those of its ticks.
#[derive(Clone, Debug)]
pub(crate) struct Scale {
    is_log: bool,
    /// Where zero is, on a logarithmic axis with values that are zero.
    zero: Option<f64>,
    range: Range<f64>,
    ticks: Vec<f64>,
}

impl Scale {
    /// Where a value is along the axis: its logarithm to base 10, or itself.
    pub(crate) fn place(&self, value: f64) -> f64 {
        match self.zero {
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

    /// The upper end of the band for zero, if there is one.
    pub(crate) fn end_of_zero(&self) -> Option<f64> {
        self.zero.map(|zero| zero + ZERO_WIDTH / 2.0)
    }

    /// The places of the ticks: as coarse as will do.
    fn ticks(&self) -> Vec<f64> {
        let start = self.end_of_zero().unwrap_or(self.range.start);
        let range = start..self.range.end;
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
        let mut ticks: Vec<f64> = Vec::new();
        for candidate in candidates {
            let places = candidate.into_iter().map(|tick| self.place(tick));
            ticks = places.filter(|place| range.contains(place)).collect();
            if ticks.len() >= few {
                break;
            }
        }
        ticks.extend(self.zero);
        ticks
    }

    /// The value at a tick, without the noise of its last bits.
    pub(crate) fn label(&self, place: f64) -> String {
        if self.zero == Some(place) {
            return "0".to_owned();
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
    use super::{Axis, Scale};

    fn labels<const N: usize>(axis: &Axis, values: [f64; N]) -> Vec<String> {
        let scale = axis.scale(values.into_iter());
        let ticks = scale.ticks.iter();
        ticks.map(|&tick| scale.label(tick)).collect()
    }

    fn of(axis: Axis) -> Scale {
        axis.scale(std::iter::empty())
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
        let labels = numbers.map(|number| of(Axis::linear("y")).label(number));
        let expected = ["0", "0.00025", "0.02", "1.5", "30", "1000", "12.5 k"];
        assert_eq!(labels, expected);
    }

    #[test]
    fn short_axes_have_ticks_too() {
        for values in [
            [1.2, 2.0],
            [1.0, 2.7],
            [0.0022, 0.0028],
            [3.5, 18.0],
            [98.0, 102.0],
        ] {
            let count = labels(&Axis::log("x"), values).len();
            assert!((4..12).contains(&count), "{values:?}: {count}");
        }
    }

    #[test]
    fn zero_has_a_place_below_all_others() {
        let axis = Axis::log("x");
        let scale = axis.scale([0.0, 0.01, 0.2].into_iter());
        let [zero, least] = [0.0, 0.01].map(|value| scale.place(value));
        assert!(zero < scale.end_of_zero().unwrap() && scale.end_of_zero().unwrap() < least);
        assert!(scale.range.contains(&zero));
        let expected = ["0.01", "0.1", "1", "0"];
        assert_eq!(labels(&axis, [0.0, 0.02, 3.0]), expected);
        assert!(of(axis).place(0.0).is_infinite());
    }

    #[test]
    fn there_is_a_range_for_all_values() {
        assert_eq!(of(Axis::log("x")).range, 0.0..1.0);
        let zero = Axis::linear("x").scale([0.0].into_iter());
        assert_eq!((zero.range, zero.ticks.len()), (0.0..1.0, 5));
        let one = Axis::log("x").scale([5.0, -1.0].into_iter()).range;
        assert!(one.end - one.start > 0.3 && one.contains(&5_f64.log10()));
    }
}
