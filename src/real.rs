//! The two scalar types of coordinates.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Sub};

use crate::lanes::{F32x8, F64x8};

mod sealed {
    use crate::lanes::Lanes;

    /// Seals [`Real`](super::Real), and holds what only kernels need.
    pub trait Sealed: Copy {
        /// Eight of them, compared at once.
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
        /// An integer that compares as the number does; both zeros have the same one. Unspecified for NaN.
        ///
        /// Only the low bits are used, as many as the scalar has.
        fn order_key(self) -> u64;
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
    ($real:ident, $bits:ident, $lanes:ident) => {
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
            fn order_key(self) -> u64 {
                // Adding zero turns -0 into +0: the two must tie, as they do in a comparison of numbers.
                let bits = (self + 0.0).to_bits();
                let sign = $bits::BITS - 1;
                // Negative numbers: all bits flipped. Others: the sign bit set.
                let mask = (bits >> sign).wrapping_neg() | (1 << sign);
                u64::from(bits ^ mask)
            }
        }
    };
}

impl_real!(f32, u32, F32x8);
impl_real!(f64, u64, F64x8);
