//! The generator that the scenes draw from: a thin cover of `oorandom` with the few draws they need.

use rapier2d::na::{self, RealField};

/// A generator whose draws depend on its seed alone.
#[derive(Clone, Debug)]
pub(crate) struct Random(oorandom::Rand32);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(oorandom::Rand32::new(seed))
    }

    /// A number in `lo..hi`.
    pub(crate) fn range<R: RealField + Copy>(&mut self, lo: R, hi: R) -> R {
        lo + (hi - lo) * self.share()
    }

    /// A number in `lo..hi` whose logarithm is uniform.
    pub(crate) fn log_range<R: RealField + Copy>(&mut self, lo: R, hi: R) -> R {
        lo * (hi / lo).powf(self.share())
    }

    /// A number in `0..1`, with the bits of an `f32`.
    fn share<R: RealField>(&mut self) -> R {
        na::convert(f64::from(self.0.rand_float()))
    }

    /// An index in `0..count`, which must not be empty.
    pub(crate) fn index(&mut self, count: usize) -> usize {
        self.0.rand_range(0..count as u32) as usize
    }
}
