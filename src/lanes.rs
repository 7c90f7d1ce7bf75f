//! Eight numbers compared at once.
//!
//! A thin layer over the processor's vectors, so that the sweep is written once for `f32`, `f64` and every
//! processor. Comparisons are those of single numbers: false when either side is NaN. Where there is no
//! vector type for a processor here, [`Portable`] leaves vectorization to the compiler.

use core::ops::BitAnd;

/// How many numbers are compared at once.
pub(crate) const LANES: usize = 8;

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

#[cfg(target_feature = "sse2")]
pub(crate) use sse2::{F32x8, F64x8, truncated_f32, truncated_f64};
#[cfg(not(target_feature = "sse2"))]
pub(crate) type F32x8 = Portable<f32>;
#[cfg(not(target_feature = "sse2"))]
pub(crate) type F64x8 = Portable<f64>;
#[cfg(not(target_feature = "sse2"))]
pub(crate) use {truncated as truncated_f32, truncated as truncated_f64};

/// Eight numbers without a vector type; the result of a comparison is a flag in each lane.
#[cfg(any(test, not(target_feature = "sse2")))]
#[cfg_attr(
    target_feature = "sse2",
    expect(unreachable_pub, reason = "used by tests only")
)]
#[derive(Clone, Copy)]
pub struct Portable<R>([R; LANES], [bool; LANES]);

#[cfg(any(test, not(target_feature = "sse2")))]
impl<R: Copy> BitAnd for Portable<R> {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(self.0, core::array::from_fn(|l| self.1[l] & other.1[l]))
    }
}

#[cfg(any(test, not(target_feature = "sse2")))]
impl<R: Copy + PartialOrd> Lanes<R> for Portable<R> {
    #[inline(always)]
    fn load(numbers: &[R; LANES]) -> Self {
        Self(*numbers, [false; LANES])
    }
    #[inline(always)]
    fn splat(number: R) -> Self {
        Self([number; LANES], [false; LANES])
    }
    #[inline(always)]
    fn le(self, other: Self) -> Self {
        Self(self.0, core::array::from_fn(|l| self.0[l] <= other.0[l]))
    }
    #[inline(always)]
    fn bits(self) -> u32 {
        (0..LANES).fold(0, |bits, l| bits | u32::from(self.1[l]) << l)
    }
}

/// The integer parts of four numbers; 0 for NaN and negative ones, and 2³¹ for all that are greater.
#[cfg(any(test, not(target_feature = "sse2")))]
#[inline(always)]
pub(crate) fn truncated<R: crate::Real>(numbers: [R; 4]) -> [u32; 4] {
    numbers.map(|number| (number.to_f64() as u32).min(1 << 31))
}

/// Vectors of 128 bits, which every x86-64 processor has.
#[cfg(target_feature = "sse2")]
mod sse2 {
    use core::ops::BitAnd;

    use safe_arch::{
        cmp_le_mask_m128, cmp_le_mask_m128d, load_unaligned_m128, load_unaligned_m128d, m128,
        m128d, max_m128, max_m128d, move_mask_m128, move_mask_m128d, set_splat_m128,
        set_splat_m128d, truncate_m128_to_m128i, truncate_m128d_to_m128i,
    };

    use super::{LANES, Lanes};

    macro_rules! vectors {
        ($name:ident, $real:ident, $vector:ident, $parts:literal, $load:ident, $splat:ident,
         $le:ident, $mask:ident) => {
            #[doc = concat!("Eight `", stringify!($real), "` in ", $parts, " vectors.")]
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
                        $load(&core::array::from_fn(|l| numbers[p * LANES / $parts + l]))
                    }))
                }
                #[inline(always)]
                fn splat(number: $real) -> Self {
                    Self([$splat(number); $parts])
                }
                #[inline(always)]
                fn le(self, other: Self) -> Self {
                    Self(core::array::from_fn(|p| $le(self.0[p], other.0[p])))
                }
                #[inline(always)]
                fn bits(self) -> u32 {
                    let mut bits = 0;
                    for p in 0..$parts {
                        bits |= $mask(self.0[p]) << (p * (LANES / $parts));
                    }
                    bits as u32
                }
            }
        };
    }

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

    vectors!(
        F32x8,
        f32,
        m128,
        2,
        load_unaligned_m128,
        set_splat_m128,
        cmp_le_mask_m128,
        move_mask_m128
    );
    vectors!(
        F64x8,
        f64,
        m128d,
        4,
        load_unaligned_m128d,
        set_splat_m128d,
        cmp_le_mask_m128d,
        move_mask_m128d
    );
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
        agrees_with_single_numbers::<f32, Portable<f32>>(numbers);
        agrees_with_single_numbers::<f64, Portable<f64>>(numbers.map(f64::from));
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
