//! Random numbers from a seed, the same on every machine.

use oorandom::Rand64;

/// A seeded source of the few kinds of random numbers that the generators need.
pub(crate) struct Random(Rand64);

impl Random {
    /// The source that belongs to `seed`.
    pub(crate) fn new(seed: u64) -> Self {
        Self(Rand64::new(u128::from(seed)))
    }

    /// A number in `low..high`.
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.0.rand_float()
    }

    /// Numbers in `low..high`.
    pub(crate) fn place<const D: usize>(&mut self, low: f64, high: f64) -> [f64; D] {
        [(); D].map(|()| self.between(low, high))
    }

    /// A whole number in `0..count`.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        self.0.rand_range(0..count as u64) as usize
    }

    /// A whole number in `low..=high`, as a coordinate.
    pub(crate) fn whole(&mut self, low: i32, high: i32) -> f64 {
        f64::from(low) + self.below((high - low) as usize + 1) as f64
    }

    /// One of `choices`.
    pub(crate) fn pick<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }

    /// Whether an event of this probability happens.
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
