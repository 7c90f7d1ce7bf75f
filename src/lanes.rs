//! Eight numbers compared at once.
//!
//! A thin layer over the `wide` crate, so that the sweep is written once for `f32` and `f64`. Comparisons
//! are those of single numbers: false when either side is NaN.

use core::ops::BitAnd;

use wide::{CmpGe, CmpLe, f32x8, f64x4};

/// How many numbers are compared at once.
pub(crate) const LANES: usize = 8;

/// Eight numbers of one scalar, or the outcome of comparing them.
pub trait Lanes<R>: Copy + BitAnd<Output = Self> {
    /// The first eight numbers of a slice that has at least as many.
    fn load(numbers: &[R]) -> Self;
    /// Eight times the same.
    fn splat(number: R) -> Self;
    /// Where `self <= other`.
    fn le(self, other: Self) -> Self;
    /// Where `self >= other`.
    fn ge(self, other: Self) -> Self;
    /// The outcome of a comparison: bit `l` for lane `l`.
    fn bits(self) -> u32;
}

impl Lanes<f32> for f32x8 {
    #[inline(always)]
    fn load(numbers: &[f32]) -> Self {
        let numbers: [f32; LANES] = numbers[..LANES].try_into().expect("eight lanes");
        Self::from(numbers)
    }
    #[inline(always)]
    fn splat(number: f32) -> Self {
        Self::splat(number)
    }
    #[inline(always)]
    fn le(self, other: Self) -> Self {
        self.cmp_le(other)
    }
    #[inline(always)]
    fn ge(self, other: Self) -> Self {
        self.cmp_ge(other)
    }
    #[inline(always)]
    fn bits(self) -> u32 {
        self.move_mask() as u32
    }
}

/// Eight `f64` in two halves.
#[derive(Clone, Copy)]
pub struct F64x8(f64x4, f64x4);

impl BitAnd for F64x8 {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0, self.1 & other.1)
    }
}

impl Lanes<f64> for F64x8 {
    #[inline(always)]
    fn load(numbers: &[f64]) -> Self {
        let (low, high) = numbers[..LANES].split_at(LANES / 2);
        let low: [f64; LANES / 2] = low.try_into().expect("four lanes");
        let high: [f64; LANES / 2] = high.try_into().expect("four lanes");
        Self(f64x4::from(low), f64x4::from(high))
    }
    #[inline(always)]
    fn splat(number: f64) -> Self {
        Self(f64x4::splat(number), f64x4::splat(number))
    }
    #[inline(always)]
    fn le(self, other: Self) -> Self {
        Self(self.0.cmp_le(other.0), self.1.cmp_le(other.1))
    }
    #[inline(always)]
    fn ge(self, other: Self) -> Self {
        Self(self.0.cmp_ge(other.0), self.1.cmp_ge(other.1))
    }
    #[inline(always)]
    fn bits(self) -> u32 {
        (self.0.move_mask() | (self.1.move_mask() << (LANES / 2))) as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn agrees_with_single_numbers<R: crate::Real>(numbers: [R; LANES]) {
        for &bound in &numbers {
            let (lanes, splat) = (R::Lanes::load(&numbers), R::Lanes::splat(bound));
            for (l, &number) in numbers.iter().enumerate() {
                assert_eq!(lanes.le(splat).bits() >> l & 1 == 1, number <= bound);
                assert_eq!(lanes.ge(splat).bits() >> l & 1 == 1, number >= bound);
            }
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
        agrees_with_single_numbers::<f32>(numbers);
        agrees_with_single_numbers::<f64>(numbers.map(f64::from));
    }
}
