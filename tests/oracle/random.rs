//! Pseudorandom numbers, which are the same on every machine.

use oorandom::Rand64;

/// A seeded generator with the methods that the inputs use.
pub(crate) struct Random(Rand64);

impl Random {
    /// A generator with this seed.
    pub(crate) fn new(seed: u64) -> Self {
        Self(Rand64::new(u128::from(seed)))
    }

    /// A number in `low..high`.
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.0.rand_float()
    }

    /// A point with coordinates in `low..high`.
    pub(crate) fn place<const D: usize>(&mut self, low: f64, high: f64) -> [f64; D] {
        [(); D].map(|()| self.between(low, high))
    }

    /// An integer in `0..count`.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        self.0.rand_range(0..count as u64) as usize
    }

    /// An integer in `low..=high`, as a coordinate.
    pub(crate) fn whole(&mut self, low: i32, high: i32) -> f64 {
        f64::from(low) + self.below((high - low) as usize + 1) as f64
    }

    /// One of `choices`.
    pub(crate) fn pick<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }

    /// True with this probability.
    pub(crate) fn chance(&mut self, probability: f64) -> bool {
        self.0.rand_float() < probability
    }

    /// Puts `items` into random order.
    pub(crate) fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            items.swap(last, self.below(last + 1));
        }
    }
}
