//! A lower bound on the motion after which two separated volumes may meet.

use super::separating_axes::{Pair, nearest_points};
use super::{VolumeKind, VolumeRef, dot};
use crate::real::Real;

/// A bound on the error of the distance of two nearly parallel segments, as a part of their lengths: rounding decides which of their points
/// count as the closest ones.
const INEXACT: f64 = 1.0 / 256.0;

impl<R: Real, const D: usize> VolumeRef<'_, R, D> {
    /// A lower bound on the sum of the [changes](Self::change_to) after which two volumes that do not [meet](Self::meets) may meet. It is at most 0
    /// if it is unknown. That includes volumes other than balls and capsules, which are as fast to test again as to compare with a bound.
    #[inline(never)]
    pub(crate) fn room(self, other: Self, slack: R) -> R {
        use VolumeKind::{Ball, Capsule};
        match (self.kind, other.kind) {
            (Ball | Capsule, Ball | Capsule) => Pair::of(self, other, slack).room_between_cores(),
            _ => R::ZERO,
        }
    }

    /// A bound on the rounding errors of its numbers.
    fn rounding(self) -> R {
        self.ball.loosened(self.half_axes) - self.ball.radius
    }
}

impl<R: Real, const D: usize> Pair<'_, R, D> {
    /// The line between the closest points separates two capsules for as long as their distance exceeds their reach.
    fn room_between_cores(&self) -> R {
        let [a, b] = self.volumes;
        let halves = self.volumes.map(VolumeRef::first_half_axis);
        let along = halves.map(|half| dot(half, self.between));
        let axis = nearest_points(self.between, halves, along);
        let squared = dot(axis, axis);
        // The square of half the axis must not underflow either.
        let is_exact = squared >= R::LEAST_EXACT * R::from_f64(8.0);
        if !is_exact {
            return R::ZERO;
        }
        let segments = a.reach_of_segments(axis) + b.reach_of_segments(axis);
        let distance = (dot(self.between, axis).abs() - segments) / squared.sqrt();
        let lengths = halves.map(|half| dot(half, half).sqrt());
        let room = distance
            - self.reach
            - (lengths[0] + lengths[1]) * R::from_f64(INEXACT)
            // The errors of both tests.
            - R::from_f64(2.0) * (a.rounding() + b.rounding());
        let half = distance * R::from_f64(0.5);
        if room < half { room } else { half }
    }
}
