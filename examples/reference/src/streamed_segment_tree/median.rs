//! The approximate median of many places, from a sample of them.

use super::entry::{Border, Entry};
use oorandom::Rand32;
use unisize::Real;

/// The seed of the random numbers, the same in every run.
const SEED: u64 = 0x5e61_7ee5;

/// Up to this many boxes, the smallest sample is taken.
const SMALL: f64 = 137.0;

/// The least number of rounds that thin a sample out.
const MIN_ROUNDS: u32 = 2;

/// Estimates medians by iterated Radon points: of boxes picked at random, the median of three medians of three, and so
/// on, with samples as large as CGAL's.
pub(super) struct Median(Rand32);

impl Median {
    pub(super) fn new() -> Self {
        Self(Rand32::new(SEED))
    }

    /// Where one of these entries begins, with about as many entries before as after it. There must be an entry.
    ///
    /// Computes in **O(n)**: of few entries nine are sampled, of many about one in twenty.
    pub(super) fn of_lows<R: Real, const D: usize>(
        &mut self,
        entries: &[Entry<R, D>],
        axis: usize,
    ) -> Border<R> {
        self.of_sample(rounds(entries.len()), entries, axis)
    }

    /// What this many rounds leave of a sample of three to that power.
    fn of_sample<R: Real, const D: usize>(
        &mut self,
        rounds: u32,
        entries: &[Entry<R, D>],
        axis: usize,
    ) -> Border<R> {
        if rounds == 0 {
            let picked = self.0.rand_range(0..entries.len() as u32);
            return entries[picked as usize].low(axis);
        }
        let [a, b, c] = core::array::from_fn(|_| self.of_sample(rounds - 1, entries, axis));
        of_three(a, b, c)
    }
}

/// How many rounds of three thin out the sample of this many entries. The sample grows almost as their number does.
fn rounds(count: usize) -> u32 {
    let more = 0.91 * (count as f64 / SMALL).ln();
    // Where this is negative, the conversion makes it 0.
    MIN_ROUNDS + more as u32
}

/// The one in the middle.
fn of_three<R: Real>(a: Border<R>, b: Border<R>, c: Border<R>) -> Border<R> {
    let (low, high) = if b.precedes(a) { (b, a) } else { (a, b) };
    if c.precedes(low) {
        low
    } else if high.precedes(c) {
        high
    } else {
        c
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use unisize::Aabb;

    fn entries(count: u32, low: impl Fn(u32) -> f32) -> Vec<Entry<f32, 1>> {
        let entry = |index| Entry {
            aabb: Aabb::new([low(index)], [f32::INFINITY]),
            index,
        };
        (0..count).map(entry).collect()
    }

    /// The share of the entries that begin before their estimated median.
    fn share_before(entries: &[Entry<f32, 1>]) -> f64 {
        let median = Median::new().of_lows(entries, 0);
        let before = entries.iter().filter(|e| e.low(0).precedes(median));
        before.count() as f64 / entries.len() as f64
    }

    #[test]
    fn medians_of_many_are_near_the_middle() {
        let shuffled = |i: u32| (i.wrapping_mul(0x9e37_79b9) >> 8) as f32;
        for low in [shuffled, |i| i as f32, |i| -(i as f32).exp2(), |_| 0.0] {
            for (count, off) in [(100, 0.4), (10_000, 0.2), (300_000, 0.1)] {
                let share = share_before(&entries(count, low));
                assert!((share - 0.5).abs() < off, "{share} of {count}");
            }
        }
    }

    #[test]
    fn the_median_of_one_is_its_own() {
        let one = entries(1, |_| -7.0);
        assert_eq!(Median::new().of_lows(&one, 0), one[0].low(0));
    }

    #[test]
    fn the_median_of_three_is_in_the_middle_whatever_their_order() {
        // Two at zero, one of each sign.
        let sorted = entries(3, |index| [-0.0, 0.0, 1.0][index as usize]);
        let [low, middle, high] = [0, 1, 2].map(|i| sorted[i].low(0));
        for [a, b, c] in [
            [low, middle, high],
            [low, high, middle],
            [middle, low, high],
            [middle, high, low],
            [high, low, middle],
            [high, middle, low],
        ] {
            assert_eq!(of_three(a, b, c), middle);
        }
        assert_eq!(of_three(low, high, low), low);
        assert_eq!(of_three(low, low, low), low);
    }

    #[test]
    fn samples_grow_with_the_numbers() {
        let sizes = [1, 137, 1000, 1 << 17, 1 << 20, 1 << 31].map(|n| 3_usize.pow(rounds(n)));
        assert_eq!(sizes, [9, 9, 27, 6561, 59_049, 129_140_163]);
    }
}
