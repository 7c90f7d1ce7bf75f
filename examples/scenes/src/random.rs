//! The generator that the scenes draw from: a thin cover of `oorandom` with the few draws they need.

/// A generator whose draws depend on its seed alone.
#[derive(Clone, Debug)]
pub(crate) struct Random(oorandom::Rand32);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(oorandom::Rand32::new(seed))
    }

    /// A number in `lo..hi`.
    pub(crate) fn range(&mut self, lo: f32, hi: f32) -> f32 {
        lo + (hi - lo) * self.0.rand_float()
    }

    /// A number in `lo..hi` whose logarithm is uniform.
    pub(crate) fn log_range(&mut self, lo: f32, hi: f32) -> f32 {
        lo * (hi / lo).powf(self.0.rand_float())
    }

    /// An index in `0..count`, which must not be empty.
    pub(crate) fn index(&mut self, count: usize) -> usize {
        self.0.rand_range(0..count as u32) as usize
    }
}
