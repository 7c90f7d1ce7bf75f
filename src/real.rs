//! The scalar types of coordinates.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Sub};

use crate::lanes::{F32x8, F64x8};

mod sealed {
    use core::fmt::Debug;

    use crate::lanes::Lanes;

    /// Seals [`Real`](super::Real), and has the items that are not public.
    pub trait Sealed: Copy {
        /// Eight of them, compared at once.
        type Lanes: Lanes<Self>;
        /// An integer of as many bits.
        type Key: Copy + Debug + Default + Ord + Send + Sync + Into<u64>;

        const ZERO: Self;
        const INFINITY: Self;
        const NEG_INFINITY: Self;
        const NAN: Self;
        /// The distance from 1 to the next number.
        const EPSILON: Self;
        /// A smaller sum of products may have lost digits to underflow.
        const LEAST_EXACT: Self;

        fn abs(self) -> Self;
        fn sqrt(self) -> Self;
        fn is_finite(self) -> bool;
        /// An integer in the order of the numbers; both zeros have the same one. Unspecified for NaN.
        fn order_key(self) -> Self::Key;
    }
}

/// The scalar type of coordinates: `f32` or `f64`. Sealed.
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
    /// Returns the nearest `f64`.
    fn to_f64(self) -> f64;
    /// Returns the number of this type that is nearest to an `f64`.
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
            type Key = $bits;

            const ZERO: Self = 0.0;
            const INFINITY: Self = $real::INFINITY;
            const NEG_INFINITY: Self = $real::NEG_INFINITY;
            const NAN: Self = $real::NAN;
            const EPSILON: Self = $real::EPSILON;
            const LEAST_EXACT: Self = $real::MIN_POSITIVE / $real::EPSILON;

            #[inline]
            fn abs(self) -> Self {
                self.abs()
            }
            #[inline]
            fn sqrt(self) -> Self {
                self.sqrt()
            }
            #[inline]
            fn is_finite(self) -> bool {
                self.is_finite()
            }
            #[inline]
            fn order_key(self) -> $bits {
                // Adding zero turns -0 into +0: the two must tie, as they do in a comparison of numbers.
                let bits = (self + 0.0).to_bits();
                let sign = $bits::BITS - 1;
                // Negative numbers: all bits flipped. Others: the sign bit set.
                let mask = (bits >> sign).wrapping_neg() | (1 << sign);
                bits ^ mask
            }
        }
    };
}

impl_real!(f32, u32, F32x8);
impl_real!(f64, u64, F64x8);
