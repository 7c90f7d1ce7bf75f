//! Vectors: eight numbers are compared at once, and four truncated.
//!
//! With this thin layer the kernel is written once for `f32`, `f64` and every processor. It uses the vectors of x86-64, of 64-bit ARM
//! and, if they are switched on, of WebAssembly, and single numbers elsewhere. Vectors compare as single numbers do: the result is
//! false if either side is NaN.

use core::ops::BitAnd;

use wide::{CmpLe, f32x4, f64x2};

/// How many numbers are compared at once.
pub(crate) const LANES: usize = 8;

/// Whether the processor compares several numbers at once. If not, comparing one at a time is faster than eight in turns, since it stops
/// at the first that is out of reach.
pub(crate) const ARE_VECTORS: bool = cfg!(any(
    target_feature = "sse2",
    target_feature = "neon",
    target_feature = "simd128"
));

/// Eight numbers of one scalar type, or the result of comparing them.
pub trait Lanes<R>: Copy + BitAnd<Output = Self> {
    /// Eight numbers.
    fn load(numbers: &[R; LANES]) -> Self;
    /// One number in all lanes.
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
    /// The integer part of each of four numbers, at least 0 and at most 2³¹; 0 for NaN. Non-decreasing in each number.
    fn truncated(numbers: [R; 4]) -> [u32; 4];
}

macro_rules! vectors {
    ($name:ident, $real:ident, $vector:ident, $parts:literal, $truncated:ident) => {
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
            #[inline(always)]
            fn truncated(numbers: [$real; 4]) -> [u32; 4] {
                #[cfg(target_feature = "sse2")]
                return $truncated(numbers);
                #[cfg(not(target_feature = "sse2"))]
                return numbers.map(|number| (number as u32).min(1 << 31));
            }
        }
    };
}

vectors!(F32x8, f32, f32x4, 2, truncated_f32);
vectors!(F64x8, f64, f64x2, 4, truncated_f64);

// x86-64 truncates in one instruction, whose result is 2³¹ for every number that does not fit. The maximum of NaN and zero is its second
// operand, zero.

#[cfg(target_feature = "sse2")]
#[inline(always)]
fn truncated_f32(numbers: [f32; 4]) -> [u32; 4] {
    let numbers = safe_arch::max_m128(numbers.into(), Default::default());
    <[i32; 4]>::from(safe_arch::truncate_m128_to_m128i(numbers)).map(|number| number as u32)
}

#[cfg(target_feature = "sse2")]
#[inline(always)]
fn truncated_f64([a, b, c, d]: [f64; 4]) -> [u32; 4] {
    let [[a, b, ..], [c, d, ..]] = [[a, b], [c, d]].map(|half| {
        let half = safe_arch::max_m128d(half.into(), Default::default());
        <[i32; 4]>::from(safe_arch::truncate_m128d_to_m128i(half))
    });
    [a, b, c, d].map(|number| number as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Four numbers truncated, in both types.
    fn truncated(numbers: [f32; 4]) -> [u32; 4] {
        let truncated = F32x8::truncated(numbers);
        assert_eq!(F64x8::truncated(numbers.map(f64::from)), truncated);
        truncated
    }

    #[test]
    fn special_numbers_are_truncated_like_others() {
        let (infinity, most) = (f32::INFINITY, 1 << 31);
        assert_eq!(truncated([0.0, -0.0, 1.99, f32::NAN]), [0, 0, 1, 0]);
        assert_eq!(
            truncated([infinity, -infinity, 1e-45, 2e9]),
            [most, 0, 0, 2_000_000_000]
        );
        assert_eq!(
            truncated([2147483648.0, 4294967296.0, f32::MAX, -1.0]),
            [most, most, most, 0]
        );
        let [below, ..] = F64x8::truncated([2147483647.9; 4]);
        assert_eq!(below, most - 1);
    }
}
