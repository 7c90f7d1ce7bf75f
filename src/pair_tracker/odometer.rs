//! How far a volume has moved, so that a pair is asked again only once its two volumes may have come to another answer.
//!
//! Each slot has an [`Odometer`], and each candidate that was asked has a [`Due`]: the sum of both odometers then, and the
//! [room](crate::volume::VolumeRef::room) that both had together. Until the sum reaches it, the answer stays. These are the failure
//! times of kinetic data structures (Basch, Guibas and Hershberger 1999) with a path in the place of a clock, or the skin of a Verlet
//! list for each pair.
//!
//! Moves are rounded up and room is rounded down, by more than the sums of a few numbers may be wrong by.

use crate::real::Real;

/// What a move is rounded up by, and room is rounded down by.
const ROUNDING: f64 = 1.0 / 64.0;

/// What two sums may be wrong by, and more.
const SUM_ROUNDING: f32 = 4.0 * f32::EPSILON;

/// A pair's room has to last for so many moves at its mean speed, or looking at it takes longer than it spares.
const WORTH_MOVES: f32 = 2.0;

/// At least as far as any point of a volume has moved since it was set to 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Odometer(f32);

/// What two odometers have to reach together. By default they have.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Due(f32);

impl Odometer {
    /// That of a volume that may have moved anywhere: all its pairs are asked.
    pub(super) const LOST: Self = Self(f32::INFINITY);

    /// Goes on by a move, at least 0. NaN counts as a move of any length.
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
    /// That of a pair that moves so far, or has so little room, that it is asked in each update, without a look at its room.
    const HOPELESS: Self = Self(-1.0);

    /// The due of a pair that has this room, and whose odometers have come so far in this number of updates.
    #[inline(always)]
    pub(super) fn of_room<R: Real>([a, b]: [Odometer; 2], room: R, moves: u32) -> Self {
        let (moved, room) = (a.0 + b.0, (room.to_f64() * (1.0 - ROUNDING)) as f32);
        match room * moves as f32 > moved * WORTH_MOVES {
            true => Self((moved + room) * (1.0 - SUM_ROUNDING)),
            false => Self::HOPELESS,
        }
    }

    /// Whether it is not worth asking for the room of the pair again.
    #[inline(always)]
    pub(super) fn is_hopeless(self) -> bool {
        self == Self::HOPELESS
    }

    /// Whether the pair is to be asked again.
    #[inline(always)]
    pub(super) fn is_reached(self, [a, b]: [Odometer; 2]) -> bool {
        // So it is if a number is NaN.
        let is_ahead = a.0 + b.0 < self.0;
        !is_ahead
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Moves, so that all room is worth a look.
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
                    // Nor is it reached by far too early, where it counts.
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
    fn what_moves_by_next_to_nothing_gets_on() {
        for by in [f64::MIN_POSITIVE, 1e-300, 1e-46, 1e-9] {
            let mut far = [moved([1.0]), Odometer::default()];
            let due = Due::of_room(far, 1e-3, MANY);
            (0..10_000).for_each(|_| far[0].advance(by));
            assert!(due.is_reached(far), "{by}");
            assert!(moved([by]) != Odometer::default());
        }
    }

    #[test]
    fn room_that_does_not_last_is_not_looked_at_again() {
        let pair = [moved([1.0]), moved([1.0])];
        for (room, moves, is_hopeless) in [(3.0, 1, true), (5.0, 1, false), (3.0, 2, false)] {
            let due = Due::of_room(pair, room, moves);
            assert_eq!(due.is_hopeless(), is_hopeless);
            assert_eq!(due.is_reached(pair), is_hopeless);
        }
    }

    #[test]
    fn what_is_beyond_all_numbers_is_asked() {
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
