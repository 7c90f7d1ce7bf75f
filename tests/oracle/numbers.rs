//! Boundary numbers: zeros, the least and the greatest ones, infinities, close neighbours.

use unisize::Real;

/// A few boundary numbers: ties, both zeros, infinities, extremes, close neighbours.
pub(crate) fn alphabet<R: Real>() -> Vec<R> {
    let mut numbers = signed_zeros();
    numbers.extend([2.0, 3.0, 0.1, -0.1, 1e7, 1e30, -1e30, 1e-38].map(R::from_f64));
    numbers.extend(neighbours::<R>(1.0));
    numbers.extend(neighbours::<R>(16_777_216.0));
    numbers.extend(&denormals::<R>()[19..22]);
    numbers.extend(extremes::<R>());
    numbers.extend([R::INFINITY, R::NEG_INFINITY]);
    numbers
}

/// The number `ulps` representable numbers above `x`, or below.
pub(crate) fn stepped<R: Real>(mut x: R, ulps: i32) -> R {
    for _ in 0..ulps {
        x = x.next_up();
    }
    for _ in ulps..0 {
        x = R::ZERO - (R::ZERO - x).next_up();
    }
    x
}

/// Both zeros, and a number on either side of them.
pub(crate) fn signed_zeros<R: Real>() -> Vec<R> {
    [-1.0, -0.0, 0.0, 1.0].map(R::from_f64).to_vec()
}

/// The least representable numbers of both signs.
pub(crate) fn denormals<R: Real>() -> Vec<R> {
    (-20..=20).map(|ulps| stepped(R::ZERO, ulps)).collect()
}

/// Numbers so large that the difference of two overflows, and ordinary ones.
pub(crate) fn extremes<R: Real>() -> Vec<R> {
    let half = R::MAX * R::from_f64(0.5);
    let mut numbers = vec![R::ZERO];
    for x in [R::ONE, half.next_up(), half, stepped(R::MAX, -1), R::MAX] {
        numbers.extend([x, R::ZERO - x]);
    }
    numbers
}

/// The seven representable numbers around `x`.
pub(crate) fn neighbours<R: Real>(x: f64) -> Vec<R> {
    (-3..=3).map(|ulps| stepped(R::from_f64(x), ulps)).collect()
}
