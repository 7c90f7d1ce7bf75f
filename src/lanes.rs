//! Eight numbers compared at once.
//!
//! A thin layer over the processor's vectors, so that the sweep is written once for `f32`, `f64` and every
//! processor: those of x86-64, 64-bit ARM and, where they are switched on, WebAssembly; single numbers elsewhere. Comparisons
//! are those of single numbers: false when either side is NaN.

use core::ops::BitAnd;

use wide::{CmpLe, f32x4, f64x2};

/// How many numbers are compared at once.
pub(crate) const LANES: usize = 8;

/// Whether the processor compares more than one number at once. If not, eight in turns take longer than one at a time, which stops at
/// the first that is out of reach.
pub(crate) const ARE_VECTORS: bool = cfg!(any(
    target_feature = "sse2",
    target_feature = "neon",
    target_feature = "simd128"
));

/// Eight numbers of one scalar type, or the result of comparing them.
pub trait Lanes<R>: Copy + BitAnd<Output = Self> {
    /// Eight numbers.
    fn load(numbers: &[R; LANES]) -> Self;
    /// The same number in all lanes.
    fn splat(number: R) -> Self;
    /// Where `self <= other`.
    fn le(self, other: Self) -> Self;
    /// Where `self >= other`.
    #[inline(always)]
    fn ge(self, other: Self) -> Self {
        other.le(self)
    }
    /// The result of a comparison: bit `l` for lane `l`.
    fn bits(self) -> u32;
}

macro_rules! vectors {
    ($name:ident, $real:ident, $vector:ident, $parts:literal) => {
        #[doc = concat!("Eight `", stringify!($real), "` in ", $parts, " vectors of 128 bits.")]
        #[derive(Clone, Copy)]
        pub struct $name([$vector; $parts]);

        impl BitAnd for $name {
            type Output = Self;
            #[inline(always)]
            fn bitand(self, other: Self) -> Self {
                Self(core::array::from_fn(|p| self.0[p] & other.0[p]))
            }
        }

        impl Lanes<$real> for $name {
            #[inline(always)]
            fn load(numbers: &[$real; LANES]) -> Self {
                Self(core::array::from_fn(|p| {
                    $vector::new(core::array::from_fn(|l| numbers[p * LANES / $parts + l]))
                }))
            }
            #[inline(always)]
            fn splat(number: $real) -> Self {
                Self([$vector::splat(number); $parts])
            }
            #[inline(always)]
            fn le(self, other: Self) -> Self {
                Self(core::array::from_fn(|p| self.0[p].cmp_le(other.0[p])))
            }
            #[inline(always)]
            fn bits(self) -> u32 {
                let mut bits = 0;
                for p in 0..$parts {
                    bits |= self.0[p].move_mask() << (p * (LANES / $parts));
                }
                bits as u32
            }
        }
    };
}

vectors!(F32x8, f32, f32x4, 2);
vectors!(F64x8, f64, f64x2, 4);

#[cfg(target_feature = "sse2")]
pub(crate) use sse2::{truncated_f32, truncated_f64};
#[cfg(not(target_feature = "sse2"))]
pub(crate) use {truncated as truncated_f32, truncated as truncated_f64};

/// The integer parts of four numbers; 0 for NaN and negative ones, and 2³¹ for all that are greater.
#[cfg(any(test, not(target_feature = "sse2")))]
#[inline(always)]
pub(crate) fn truncated<R: crate::Real>(numbers: [R; 4]) -> [u32; 4] {
    numbers.map(|number| (number.to_f64() as u32).min(1 << 31))
}

/// Truncation as x86-64 has it in one instruction; its result is 2³¹ for all that does not fit.
#[cfg(target_feature = "sse2")]
mod sse2 {
    use safe_arch::{
        m128, m128d, max_m128, max_m128d, truncate_m128_to_m128i, truncate_m128d_to_m128i,
    };

    /// The integer parts of four numbers; 0 for NaN and negative ones, and 2³¹ for all that are greater.
    #[inline(always)]
    pub(crate) fn truncated_f32(numbers: [f32; 4]) -> [u32; 4] {
        // Of NaN and zero the maximum is the second.
        let numbers = max_m128(m128::from(numbers), m128::default());
        <[i32; 4]>::from(truncate_m128_to_m128i(numbers)).map(|number| number as u32)
    }

    /// The same for `f64`.
    #[inline(always)]
    pub(crate) fn truncated_f64([a, b, c, d]: [f64; 4]) -> [u32; 4] {
        let halves = [[a, b], [c, d]].map(|half| {
            let half = max_m128d(m128d::from(half), m128d::default());
            <[i32; 4]>::from(truncate_m128d_to_m128i(half))
        });
        [halves[0][0], halves[0][1], halves[1][0], halves[1][1]].map(|number| number as u32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn agrees_with_single_numbers<R: Copy + PartialOrd, L: Lanes<R>>(numbers: [R; LANES]) {
        for &bound in &numbers {
            let (lanes, splat) = (L::load(&numbers), L::splat(bound));
            for (l, &number) in numbers.iter().enumerate() {
                assert_eq!(lanes.le(splat).bits() >> l & 1 == 1, number <= bound);
                assert_eq!(lanes.ge(splat).bits() >> l & 1 == 1, number >= bound);
            }
            let both = lanes.le(splat) & lanes.ge(splat);
            assert_eq!(both.bits(), lanes.le(splat).bits() & lanes.ge(splat).bits());
            assert!(lanes.le(splat).bits() < 1 << LANES);
        }
    }

    #[test]
    fn comparisons_agree_with_those_of_single_numbers() {
        const INF: f32 = f32::INFINITY;
        let numbers = [
            0.0,
            -0.0,
            1.0,
            f32::NAN,
            INF,
            -INF,
            1e-45,
            1.0_f32.next_up(),
        ];
        agrees_with_single_numbers::<f32, F32x8>(numbers);
        agrees_with_single_numbers::<f64, F64x8>(numbers.map(f64::from));
    }

    #[test]
    fn truncation_saturates() {
        const INF: f32 = f32::INFINITY;
        let numbers = [
            0.0,
            -0.0,
            0.99,
            1.0,
            -1.0,
            f32::NAN,
            INF,
            -INF,
            2147483520.0,
            2147483648.0,
            4294967296.0,
            1e-45,
        ];
        let expected = [
            0,
            0,
            0,
            1,
            0,
            0,
            1 << 31,
            0,
            2147483520,
            1 << 31,
            1 << 31,
            0,
        ];
        for (numbers, expected) in numbers.chunks(4).zip(expected.chunks(4)) {
            let numbers: [f32; 4] = numbers.try_into().unwrap();
            assert_eq!(truncated(numbers), expected);
            assert_eq!(truncated_f32(numbers), expected);
            assert_eq!(truncated(numbers.map(f64::from)), expected);
            assert_eq!(truncated_f64(numbers.map(f64::from)), expected);
        }
    }
}
