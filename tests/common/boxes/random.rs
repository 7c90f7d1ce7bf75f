//! The random generator of the scenes, on top of `oorandom`.

use std::ops::{Add, Mul, Sub};

/// A generator whose numbers depend only on its seed.
#[derive(Clone, Debug)]
pub(crate) struct Random(oorandom::Rand32);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(oorandom::Rand32::new(seed))
    }

    /// A number in `lo..hi`, with the random bits of an `f32`.
    pub(crate) fn range<R>(&mut self, lo: R, hi: R) -> R
    where
        R: Copy + From<f32> + Add<Output = R> + Sub<Output = R> + Mul<Output = R>,
    {
        lo + (hi - lo) * R::from(self.0.rand_float())
    }

    /// An index in `0..count`, which must not be empty.
    pub(crate) fn index(&mut self, count: usize) -> usize {
        self.0.rand_range(0..count as u32) as usize
    }
}
