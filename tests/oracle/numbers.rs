//! Boundary numbers: zeros, the smallest and largest numbers, infinities, close neighbours.

use unisize::Real;

/// The properties of a scalar that the inputs use.
pub(crate) trait Number: Real {
    /// The largest finite number.
    const LARGEST: Self;

    /// The smallest number above this one.
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

/// Some boundary numbers: both zeros, denormals, infinities, extremes whose differences overflow, close neighbours.
pub(crate) fn alphabet<R: Number>() -> Vec<R> {
    let numbers = [-1.0, -0.0, 0.0, 1.0, 2.0, 3.0, 0.1, -0.1];
    let mut numbers = numbers.map(R::from_f64).to_vec();
    numbers.extend([1e7, 1e30, -1e30, 1e-38].map(R::from_f64));
    for (x, ulps) in [(1.0, 3), (16_777_216.0, 3), (0.0, 1)] {
        numbers.extend((-ulps..=ulps).map(|ulps| stepped(R::from_f64(x), ulps)));
    }
    let [zero, one, half] = [0.0, 1.0, 0.5].map(R::from_f64);
    let half = R::LARGEST * half;
    numbers.push(zero);
    let below_largest = stepped(R::LARGEST, -1);
    for x in [one, half.successor(), half, below_largest, R::LARGEST] {
        numbers.extend([x, zero - x]);
    }
    numbers.extend([f64::INFINITY, f64::NEG_INFINITY].map(R::from_f64));
    numbers
}

/// The number that is `ulps` representable numbers above `x`, or below if negative.
pub(crate) fn stepped<R: Number>(mut x: R, ulps: i32) -> R {
    for _ in 0..ulps {
        x = x.successor();
    }
    for _ in ulps..0 {
        x = R::from_f64(0.0) - (R::from_f64(0.0) - x).successor();
    }
    x
}
