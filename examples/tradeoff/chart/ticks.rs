//! Where a logarithmic axis has its ticks, also if it is short.

use std::ops::Range;

/// The digits at which a long axis may have ticks, coarse ones first.
const DIGITS: [&[f64]; 2] = [&[1.0], &[1.0, 2.0, 5.0]];

/// The steps between the ticks of a short axis, as parts of a power of ten, coarse ones first.
const STEPS: [f64; 3] = [0.5, 0.2, 0.1];

/// Fewer ticks say too little.
const FEW: usize = 4;

/// An axis is short if it ends at less than this times its start.
const SHORT: f64 = 8.0;

/// Round numbers within the range: as coarse as will do.
pub(super) fn of(range: &Range<f64>) -> Vec<f64> {
    let first = range.start.log10().floor() as i32;
    let last = range.end.log10().ceil() as i32;
    let is_short = range.end / range.start < SHORT;
    let by_digits = DIGITS.iter().map(|digits| {
        let decades = (first..=last).map(|decade| 10f64.powi(decade));
        let ticks = decades.flat_map(|decade| digits.iter().map(move |digit| digit * decade));
        ticks
            .filter(|tick| range.contains(tick))
            .collect::<Vec<_>>()
    });
    let by_steps = (0..3).flat_map(|finer| {
        STEPS.map(|step| {
            let step = step * 10f64.powi(last - finer);
            let numbers = (range.start / step).ceil() as i64..=(range.end / step).floor() as i64;
            numbers.map(|number| number as f64 * step).collect()
        })
    });
    let candidates: Vec<Vec<_>> = if is_short {
        by_steps.collect()
    } else {
        by_digits.collect()
    };
    let enough = candidates.iter().find(|ticks| ticks.len() >= FEW);
    enough.or(candidates.last()).cloned().unwrap_or_default()
}

/// A number without the noise of its last bits.
pub(super) fn label(tick: f64) -> String {
    let digits = (2.0 - tick.log10().floor()).clamp(0.0, 9.0) as usize;
    let text = format!("{tick:.digits$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::{label, of};

    #[test]
    fn long_axes_have_powers_of_ten() {
        assert_eq!(of(&(0.9..1200.0)), [1.0, 10.0, 100.0, 1000.0]);
    }

    #[test]
    fn short_axes_have_ticks_too() {
        for range in [1.05..2.1, 0.9..3.0, 0.0021..0.0029, 3.0..20.0, 95.0..105.0] {
            assert!(
                (4..12).contains(&of(&range).len()),
                "{range:?}: {:?}",
                of(&range)
            );
        }
    }

    #[test]
    fn labels_are_short() {
        let ticks = [0.02, 1.5, 30.000_000_001, 1000.0];
        assert_eq!(ticks.map(label), ["0.02", "1.5", "30", "1000"]);
    }
}
