//! Boundary numbers: zeros, the least and the greatest ones, infinities, close neighbours.

use unisize::Real;

/// What the inputs need to know of a scalar.
pub(crate) trait Number: Real {
    /// The greatest finite number.
    const LARGEST: Self;

    /// The least number greater than this one.
    fn successor(self) -> Self;
}

macro_rules! impl_number {
    ($number:ident) => {
        impl Number for $number {
            const LARGEST: Self = $number::MAX;

            fn successor(self) -> Self {
                self.next_up()
            }
        }
    };
}

impl_number!(f32);
impl_number!(f64);

/// A few boundary numbers: ties, both zeros, infinities, extremes, close neighbours.
pub(crate) fn alphabet<R: Number>() -> Vec<R> {
    let mut numbers = signed_zeros();
    numbers.extend([2.0, 3.0, 0.1, -0.1, 1e7, 1e30, -1e30, 1e-38].map(R::from_f64));
    numbers.extend(neighbours::<R>(1.0));
    numbers.extend(neighbours::<R>(16_777_216.0));
    numbers.extend(&denormals::<R>()[19..22]);
    numbers.extend(extremes::<R>());
    numbers.extend([R::from_f64(f64::INFINITY), R::from_f64(f64::NEG_INFINITY)]);
    numbers
}

/// The number `ulps` representable numbers above `x`, or below.
pub(crate) fn stepped<R: Number>(mut x: R, ulps: i32) -> R {
    for _ in 0..ulps {
        x = x.successor();
    }
    for _ in ulps..0 {
        x = R::from_f64(0.0) - (R::from_f64(0.0) - x).successor();
    }
    x
}

/// Both zeros, and a number on either side of them.
pub(crate) fn signed_zeros<R: Number>() -> Vec<R> {
    [-1.0, -0.0, 0.0, 1.0].map(R::from_f64).to_vec()
}

/// The least representable numbers of both signs.
pub(crate) fn denormals<R: Number>() -> Vec<R> {
    (-20..=20)
        .map(|ulps| stepped(R::from_f64(0.0), ulps))
        .collect()
}

/// Numbers so large that the difference of two overflows, and ordinary ones.
pub(crate) fn extremes<R: Number>() -> Vec<R> {
    let half = R::LARGEST * R::from_f64(0.5);
    let mut numbers = vec![R::from_f64(0.0)];
    for x in [
        R::from_f64(1.0),
        half.successor(),
        half,
        stepped(R::LARGEST, -1),
        R::LARGEST,
    ] {
        numbers.extend([x, R::from_f64(0.0) - x]);
    }
    numbers
}

/// The seven representable numbers around `x`.
pub(crate) fn neighbours<R: Number>(x: f64) -> Vec<R> {
    (-3..=3).map(|ulps| stepped(R::from_f64(x), ulps)).collect()
}
