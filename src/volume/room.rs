//! How far two volumes that are apart may move before they meet.

use super::{Pair, VolumeKind, VolumeRef, dot, nearest_points};
use crate::real::Real;

/// What the distance of two segments may be wrong by, in their lengths, where they are nearly parallel: then rounding decides which of
/// their points are taken for the nearest ones.
const INEXACT: f64 = 1.0 / 256.0;

impl<R: Real, const D: usize> VolumeRef<'_, R, D> {
    /// How far two volumes that do not [meet](Self::meets) may move, in all, before they do, if each moves by the
    /// [change](Self::change_to) of all its numbers. Not above 0 if that is not known, as where one is neither a ball nor a capsule: to ask
    /// those again takes no longer than to look at their room.
    #[inline(never)]
    pub(crate) fn room(self, other: Self, slack: R) -> R {
        use VolumeKind::{Ball, Capsule};
        match (self.kind, other.kind) {
            (Ball | Capsule, Ball | Capsule) => Pair::of(self, other, slack).room_between_cores(),
            _ => R::ZERO,
        }
    }

    /// What rounding may do to its numbers.
    fn rounding(self) -> R {
        self.ball.loosened(self.half_axes) - self.ball.radius
    }
}

impl<R: Real, const D: usize> Pair<'_, R, D> {
    /// As long as two capsules are farther apart than they reach, the points of their segments that are nearest to each other prove it.
    fn room_between_cores(&self) -> R {
        let [a, b] = self.volumes;
        let halves = self.volumes.map(VolumeRef::first_half_axis);
        let along = halves.map(|half| dot(half, self.between));
        let axis = nearest_points(self.between, halves, along);
        let squared = dot(axis, axis);
        // The square of half of it must not underflow either.
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
            // What both answers may be wrong by.
            - R::from_f64(2.0) * (a.rounding() + b.rounding());
        let half = distance * R::from_f64(0.5);
        if room < half { room } else { half }
    }
}
