//! How far ahead a proxy's fat box reaches.
//!
//! Bodies mostly keep their direction. So the fat box is the box, extended along its last move by a number of further moves, and by a skin
//! to all sides.
//!
//! A longer foresight makes fewer searches and more candidates to compare. Fat boxes reach as many moves ahead as take a box half its size
//! on average, and no more than [`LONGEST`], because sooner or later bodies turn.

use crate::aabb::{Aabb, max, min};
use crate::real::Real;

/// Box sizes: how far ahead fat boxes reach, at the mean speed. If larger: more candidates where bodies are fast. If smaller: more searches.
const AHEAD: f64 = 0.5;

/// Moves: the longest foresight. If larger: where bodies are slow, more candidates than searches are saved. If smaller: more searches.
const LONGEST: f64 = 32.0;

/// Moves: the foresight before anything has moved. If larger: where the first body that moves is huge, thousands of candidates. If smaller:
/// the first boxes that move soon leave their fat boxes again.
const FIRST: f64 = 8.0;

/// A share of the extension along the move: how far the fat box extends to all sides. If larger: more candidates. If smaller: members of
/// crowds, which keep turning, leave their fat boxes a third more often.
const SKIN: f64 = 0.125;

/// A share of the size of the box: the most that the skin may be. If larger: more candidates where bodies are fast. If smaller: fast bodies
/// that turn leave their fat boxes.
const WIDEST_SKIN: f64 = 0.25;

/// Proxies: the sample from which the mean speed is estimated. If larger: time. If smaller: a few outliers decide.
const SPEED_SAMPLE: usize = 128;

/// The divisor of foresight when there are too many candidates. If larger: foresight that would pay is lost. If smaller: several searches
/// until there are few enough.
const CUT: u16 = 4;

/// One part in this many, plus 1: how much the limit grows in each full search after a cut, so that it is doubled in 17. If larger: foresight
/// that would pay is lost. If smaller: too many candidates are found, and dropped, again and again.
const REGROWN_ONE_IN: f64 = 24.0;

/// For how many moves ahead fat boxes are made.
#[derive(Clone, Copy, Debug)]
pub(super) struct Foresight {
    pub(super) moves: u16,
    /// The most moves, less than [`LONGEST`] after there were too many candidates.
    limit: f64,
}

impl Default for Foresight {
    fn default() -> Self {
        Self {
            moves: FIRST as u16,
            limit: LONGEST,
        }
    }
}

impl Foresight {
    /// The foresight of a full search. `speed()` is the mean speed in box sizes per move, if anything moves.
    pub(super) fn renewed(mut self, speed: impl FnOnce() -> Option<f64>) -> Self {
        self.limit = (self.limit + (self.limit + 1.0) / REGROWN_ONE_IN).min(LONGEST);
        let moves = speed().map_or(FIRST, |speed| AHEAD / speed);
        // Rounded down, so there are none where bodies are too fast.
        self.moves = moves.min(self.limit) as u16;
        self
    }

    /// Shortens the foresight, because there are too many candidates.
    pub(super) fn shorten(&mut self) {
        self.moves /= CUT;
        self.limit = f64::from(self.moves);
    }

    /// The fat box of a proxy whose box was `before` and is `now`. It contains `now`, for any numbers.
    pub(super) fn fat_box<R: Real, const D: usize>(
        self,
        now: &Aabb<R, D>,
        before: &Aabb<R, D>,
    ) -> Aabb<R, D> {
        if self.moves == 0 || !before.is_valid() {
            return *now;
        }
        let moves = R::from_f64(f64::from(self.moves));
        let [skin, widest] = [SKIN, WIDEST_SKIN].map(R::from_f64);
        let steps: [R; D] = core::array::from_fn(|k| step(now, before, k));
        let longest = steps
            .iter()
            .fold(R::ZERO, |m, &s| max(max(m, s), R::ZERO - s));
        let mut fat = *now;
        for k in 0..D {
            // No more than the size of the box. So boxes of one size have at most a constant factor more candidates than pairs.
            let size = now.maxs[k] - now.mins[k];
            let ahead = max(min(steps[k] * moves, size), R::ZERO - size);
            let aside = min(longest * moves * skin, size * widest);
            fat.mins[k] = now.mins[k] + min(ahead, R::ZERO) - aside;
            fat.maxs[k] = now.maxs[k] + max(ahead, R::ZERO) + aside;
        }
        // Infinite boxes make a NaN.
        if fat.contains(now) { fat } else { *now }
    }
}

/// How far the proxies of these slots have moved along each axis in box sizes, on average, by a sample; `None` if all are new, infinite or
/// at rest.
pub(super) fn mean_speed<R: Real, const D: usize>(
    moved: &[u32],
    now: &[Aabb<R, D>],
    before: &[Aabb<R, D>],
) -> Option<f64> {
    let (mut sum, mut count) = (0.0, 0);
    // The sample is chosen by slot and sorted, because threads write their notes in another order.
    let one_in = (moved.len() / SPEED_SAMPLE + 1) as u32;
    let is_sampled = |slot: &u32| (slot.wrapping_mul(0x9e37_79b9) >> 8) % one_in == 0;
    let mut sample: Vec<_> = moved.iter().copied().filter(is_sampled).collect();
    sample.sort_unstable();
    for slot in sample {
        let (now, before) = (&now[slot as usize], &before[slot as usize]);
        for k in 0..D {
            let [size, step] = [now.maxs[k] - now.mins[k], step(now, before, k)].map(R::to_f64);
            let relative = (step / size).abs();
            if relative.is_finite() {
                // A proxy that has jumped far says nothing about the others.
                sum += relative.min(1.0);
                count += 1;
            }
        }
    }
    (sum > 0.0).then(|| sum / f64::from(count))
}

/// How far the centre has moved along an axis.
#[inline(always)]
fn step<R: Real, const D: usize>(now: &Aabb<R, D>, before: &Aabb<R, D>, axis: usize) -> R {
    let sum = (now.mins[axis] - before.mins[axis]) + (now.maxs[axis] - before.maxs[axis]);
    sum * R::from_f64(0.5)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: f32, y: f32) -> Aabb<f32, 2> {
        Aabb::new([x, y], [x + 1.0, y + 1.0])
    }

    #[test]
    fn it_lies_ahead() {
        let fat = Foresight::default().fat_box(&at(0.0, 0.0), &at(-0.1, 0.0));
        assert!(fat.contains(&at(0.8, 0.0)) && !fat.contains(&at(-0.2, 0.0)));
        // Never by more than the size of the box and a quarter to each side.
        let fat = Foresight::default().fat_box(&at(0.0, 0.0), &at(-100.0, 0.0));
        assert_eq!(fat, Aabb::new([-0.25, -0.25], [2.25, 1.25]));
    }

    #[test]
    fn a_new_or_resting_box_has_no_speed() {
        let now = [at(0.0, 0.0)];
        assert_eq!(mean_speed(&[0], &now, &[Aabb::ABSENT]), None);
        assert_eq!(mean_speed(&[0], &now, &now), None);
        assert_eq!(mean_speed(&[0], &now, &[at(-0.5, 0.0)]), Some(0.25));
    }

    #[test]
    fn it_reaches_half_a_size_ahead_and_no_farther_than_the_longest() {
        let moves = |speed| Foresight::default().renewed(|| speed).moves;
        let speeds = [None, Some(1e-9), Some(0.1), Some(0.5), Some(0.51)];
        assert_eq!(speeds.map(moves), [8, 32, 5, 1, 0]);
    }

    #[test]
    fn a_shortened_foresight_grows_again_step_by_step() {
        let mut foresight = Foresight::default();
        // From none as well.
        while foresight.moves > 0 {
            foresight.shorten();
        }
        let grown = (0..100).map(|_| {
            foresight = foresight.renewed(|| Some(1e-9));
            foresight.moves
        });
        let grown: Vec<_> = grown.collect();
        assert!(grown.is_sorted());
        assert_eq!([15, 16, 99].map(|i| grown[i]), [0, 1, 32]);
    }
}
