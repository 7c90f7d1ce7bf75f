//! How far volumes have moved, so that a pair is tested again only once its answer may have changed.
//!
//! Each slot has an [`Odometer`], and each candidate that was tested has a [`Due`]: the sum of both odometers at that time, plus the
//! [room](crate::volume::VolumeRef::room) between the two volumes. Until the odometers reach it, the answer stays the same. These are the
//! failure times of kinetic data structures (Basch, Guibas and Hershberger 1999) with a path in place of a clock, or a Verlet list with a
//! skin for each pair.
//!
//! Moves are rounded up and room is rounded down, by more than the error of a sum of a few numbers.

use crate::real::Real;

/// A share by which moves are rounded up, and room is rounded down.
const ROUNDING: f64 = 1.0 / 64.0;

/// A bound on the relative error of two sums.
const SUM_ROUNDING: f32 = 4.0 * f32::EPSILON;

/// Moves for which the room of a pair must last at its mean speed. If it does not, computing the room takes longer than it saves.
const WORTH_MOVES: f32 = 2.0;

/// An upper bound on how far any point of a volume has moved since the odometer was set to 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Odometer(f32);

/// The sum that two odometers must reach. By default it is reached.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Due(f32);

impl Odometer {
    /// The odometer of a volume that may have moved anywhere: all its pairs are tested.
    pub(super) const LOST: Self = Self(f32::INFINITY);

    /// Adds a move of at least 0. NaN counts as a move of any length.
    #[inline(always)]
    pub(super) fn advance<R: Real>(&mut self, by: R) {
        let rounded = (by.to_f64() * (1.0 + ROUNDING)) as f32;
        // It may have been rounded to 0.
        let is_tiny = by > R::ZERO && rounded < f32::MIN_POSITIVE;
        let by = if is_tiny { f32::MIN_POSITIVE } else { rounded };
        self.0 = (self.0 + by) * (1.0 + SUM_ROUNDING);
    }
}

impl Due {
    /// The due of a pair that moves so far, or has so little room, that it is tested in each update, and its room is not computed.
    const HOPELESS: Self = Self(-1.0);

    /// The due of a pair with this room, whose odometers have come so far in this number of updates.
    #[inline(always)]
    pub(super) fn of_room<R: Real>([a, b]: [Odometer; 2], room: R, moves: u32) -> Self {
        let (moved, room) = (a.0 + b.0, (room.to_f64() * (1.0 - ROUNDING)) as f32);
        match room * moves as f32 > moved * WORTH_MOVES {
            true => Self((moved + room) * (1.0 - SUM_ROUNDING)),
            false => Self::HOPELESS,
        }
    }

    /// Whether the room of the pair is not worth computing again.
    #[inline(always)]
    pub(super) fn is_hopeless(self) -> bool {
        self == Self::HOPELESS
    }

    /// Whether the pair must be tested again.
    #[inline(always)]
    pub(super) fn is_reached(self, [a, b]: [Odometer; 2]) -> bool {
        // True if a number is NaN.
        let is_ahead = a.0 + b.0 < self.0;
        !is_ahead
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// So many moves that all room is worth computing.
    const MANY: u32 = u32::MAX;

    fn moved(moves: impl IntoIterator<Item = f64>) -> Odometer {
        let mut odometer = Odometer::default();
        moves.into_iter().for_each(|by| odometer.advance(by));
        odometer
    }

    #[test]
    fn a_due_is_reached_no_later_than_the_room_is_used_up() {
        for size in [1e-30, 1e-3, 1.0, 7.0, 1e30] {
            for before in [0.0, 1e-4, 1.0, 1e6] {
                for parts in [1e-12, 1e-7, 0.013, 0.5, 1.0, 30.0] {
                    let start = [moved([before * size]), moved([2.0 * before * size])];
                    let due = Due::of_room(start, parts * size, MANY);
                    for moves in [1, 3, 1000] {
                        let mut pair = start;
                        (0..moves).for_each(|i| {
                            pair[i % 2].advance(parts * size / moves as f64);
                        });
                        assert!(due.is_reached(pair), "{size} {before} {parts} {moves}");
                    }
                    // Nor is it reached far too early, where that matters.
                    if parts > before / 1000.0 && parts * size > 1e-30 {
                        assert!(!due.is_reached(start));
                        let [a, mut b] = start;
                        b.advance(0.95 * parts * size);
                        assert!(!due.is_reached([a, b]), "{size} {before} {parts}");
                    }
                }
            }
        }
    }

    #[test]
    fn tiny_moves_add_up() {
        for by in [f64::MIN_POSITIVE, 1e-300, 1e-46, 1e-9] {
            let mut far = [moved([1.0]), Odometer::default()];
            let due = Due::of_room(far, 1e-3, MANY);
            (0..10_000).for_each(|_| far[0].advance(by));
            assert!(due.is_reached(far), "{by}");
            assert!(moved([by]) != Odometer::default());
        }
    }

    #[test]
    fn room_that_does_not_last_is_not_computed_again() {
        let pair = [moved([1.0]), moved([1.0])];
        for (room, moves, is_hopeless) in [(3.0, 1, true), (5.0, 1, false), (3.0, 2, false)] {
            let due = Due::of_room(pair, room, moves);
            assert_eq!(due.is_hopeless(), is_hopeless);
            assert_eq!(due.is_reached(pair), is_hopeless);
        }
    }

    #[test]
    fn infinite_and_nan_moves_reach_any_due() {
        let still = Odometer::default();
        for odd in [f64::NAN, f64::INFINITY, 1e300] {
            let pair = [still, moved([odd])];
            assert!(Due::of_room([still; 2], 1.0, 1).is_reached(pair));
            assert!(Due::of_room(pair, 1.0, 1).is_reached(pair));
        }
        for odd in [f64::NAN, -1.0, f64::NEG_INFINITY, 0.0] {
            assert!(Due::of_room([still; 2], odd, 1).is_reached([still; 2]));
        }
        let lost = [still, Odometer::LOST];
        assert!(Due::of_room(lost, 1.0, 1).is_reached(lost));
        assert!(Due::default().is_reached([still; 2]));
    }
}
