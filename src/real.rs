//! The two scalar types of coordinates.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Sub};

use crate::lanes::{self, F32x8, F64x8};

mod sealed {
    use crate::lanes::Lanes;

    /// Seals [`Real`](super::Real), and holds what only kernels need.
    pub trait Sealed: Copy {
        /// Eight of them at once.
        type Lanes: Lanes<Self>;

        const ZERO: Self;
        const INFINITY: Self;
        const NEG_INFINITY: Self;
        /// The greatest finite number.
        const MAX: Self;
        const NAN: Self;
        /// The distance from 1 to the next number.
        const EPSILON: Self;

        fn abs(self) -> Self;
        fn sqrt(self) -> Self;
        fn is_nan(self) -> bool;
        fn is_finite(self) -> bool;
        /// The least number greater than this one; infinity and NaN stay as they are.
        fn next_up(self) -> Self;
        /// An integer that compares as the number does; both zeros have the same one. Unspecified for NaN.
        ///
        /// Only the low bits are used, as many as the scalar has.
        fn order_key(self) -> u64;
        /// The integer parts of four numbers, non-decreasing in each; 0 for NaN and negative ones, 2³¹ for all that are greater.
        fn truncated(numbers: [Self; 4]) -> [u32; 4];
    }
}

/// A scalar that boxes can be made of: `f32` or `f64`. Sealed.
pub trait Real:
    sealed::Sealed
    + Copy
    + Debug
    + Default
    + PartialEq
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Send
    + Sync
    + 'static
{
    /// The nearest `f64`.
    fn to_f64(self) -> f64;
    /// The number of this type that is nearest to an `f64`.
    fn from_f64(x: f64) -> Self;
}

macro_rules! impl_real {
    ($real:ident, $bits:ident, $lanes:ident, $truncated:ident) => {
        impl Real for $real {
            #[inline]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            #[inline]
            fn from_f64(x: f64) -> Self {
                x as Self
            }
        }

        impl sealed::Sealed for $real {
            type Lanes = $lanes;

            const ZERO: Self = 0.0;
            const INFINITY: Self = $real::INFINITY;
            const NEG_INFINITY: Self = $real::NEG_INFINITY;
            const MAX: Self = $real::MAX;
            const NAN: Self = $real::NAN;
            const EPSILON: Self = $real::EPSILON;

            #[inline]
            fn abs(self) -> Self {
                self.abs()
            }
            #[inline]
            fn sqrt(self) -> Self {
                self.sqrt()
            }
            #[inline]
            fn is_nan(self) -> bool {
                self.is_nan()
            }
            #[inline]
            fn is_finite(self) -> bool {
                self.is_finite()
            }
            #[inline]
            fn next_up(self) -> Self {
                self.next_up()
            }
            #[inline]
            fn order_key(self) -> u64 {
                // Adding zero turns -0 into +0: the two must tie, as they do in a comparison of numbers.
                let bits = (self + 0.0).to_bits();
                let sign = $bits::BITS - 1;
                // Negative numbers: all bits flipped. Others: the sign bit set.
                let mask = (bits >> sign).wrapping_neg() | (1 << sign);
                u64::from(bits ^ mask)
            }
            #[inline(always)]
            fn truncated(numbers: [Self; 4]) -> [u32; 4] {
                lanes::$truncated(numbers)
            }
        }
    };
}

impl_real!(f32, u32, F32x8, truncated_f32);
impl_real!(f64, u64, F64x8, truncated_f64);

#[cfg(test)]
mod tests {
    use super::sealed::Sealed;
    use super::*;

    fn keys_are_ordered<R: Real>(sorted: &[R]) {
        for w in sorted.windows(2) {
            assert_eq!(
                w[0].partial_cmp(&w[1]),
                Some(w[0].order_key().cmp(&w[1].order_key())),
                "{w:?}"
            );
        }
    }

    #[test]
    fn order_keys_follow_the_numbers() {
        keys_are_ordered(&[
            f32::NEG_INFINITY,
            f32::MIN,
            -1.0,
            -f32::MIN_POSITIVE,
            -1e-45,
            -0.0,
            0.0,
            1e-45,
            f32::MIN_POSITIVE,
            1.0,
            1.0_f32.next_up(),
            f32::MAX,
            f32::INFINITY,
        ]);
        keys_are_ordered(&[
            f64::NEG_INFINITY,
            f64::MIN,
            -1.0,
            -5e-324,
            -0.0,
            0.0,
            5e-324,
            1.0,
            f64::MAX,
            f64::INFINITY,
        ]);
        assert!(f32::INFINITY.order_key() <= u64::from(u32::MAX));
    }
}
