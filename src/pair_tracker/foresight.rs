//! How far ahead a proxy's fat box reaches.
//!
//! Things keep going where they went: the fat box is the box, inflated in the direction of its last move as far as it will get in a
//! number of further moves, and by a skin to all sides.
//!
//! The farther ahead, the fewer searches and the more candidates to compare. What pays depends on how far a box gets: boxes are inflated
//! for as many moves as take boxes half their size ahead on average, and for no more than [`LONGEST`], for sooner or later things turn. Finding the
//! best number scene by scene, by what each has cost, was tried and gains nothing on that.

use crate::aabb::{Aabb, max, min};
use crate::real::Real;
use crate::tuning::foresight::{
    AHEAD, CUT, CUT_RUNS, FIRST, LONGEST, SKIN, SPEED_SAMPLE, WIDEST_SKIN,
};

/// For how many moves ahead boxes are inflated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Foresight {
    pub(super) moves: u16,
    /// Whether the user has fixed it.
    pub(super) is_fixed: bool,
    /// No more than this, since there were too many candidates.
    limit: u16,
    /// Full searches until the limit is doubled.
    rest: u32,
}

impl Foresight {
    /// A foresight that goes by how fast things move, or is fixed at this number of moves.
    pub(super) fn new(fixed: Option<u16>) -> Self {
        Self {
            moves: fixed.unwrap_or(FIRST),
            is_fixed: fixed.is_some(),
            limit: LONGEST,
            rest: 0,
        }
    }

    /// The foresight of a full search, where things move by `speed()` box sizes on average, if anything moves.
    pub(super) fn renewed(mut self, speed: impl FnOnce() -> Option<f64>) -> Self {
        if self.is_fixed {
            return self;
        }
        if self.limit < LONGEST {
            match self.rest.checked_sub(1) {
                Some(rest) => self.rest = rest,
                None => self.limit_to((2 * self.limit).max(1)),
            }
        }
        let moves = speed().map_or(f64::from(FIRST), |speed| AHEAD / speed);
        // Rounded down, so there are none where things are too fast.
        self.moves = moves.min(f64::from(self.limit)) as u16;
        self
    }

    /// Looks less far ahead, because there are too many candidates.
    pub(super) fn shorten(&mut self) {
        self.moves /= CUT;
        self.limit_to(self.moves);
    }

    fn limit_to(&mut self, limit: u16) {
        self.limit = limit.min(LONGEST);
        self.rest = CUT_RUNS;
    }

    /// The fat box of a proxy that was at `before` and is at `now`. It contains `now`, for any numbers.
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
            // No more than the size of the box: for boxes of one size, there are then at most a constant factor more
            // candidates than pairs.
            let size = now.maxs[k] - now.mins[k];
            let ahead = max(min(steps[k] * moves, size), R::ZERO - size);
            let aside = min(longest * moves * skin, size * widest);
            fat.mins[k] = now.mins[k] + min(ahead, R::ZERO) - aside;
            fat.maxs[k] = now.maxs[k] + max(ahead, R::ZERO) + aside;
        }
        // It has a NaN if the boxes are infinite.
        if fat.contains(now) { fat } else { *now }
    }
}

/// How far slots have moved on each axis in box sizes, on average, by a sample; `None` if all are new, infinite or still.
pub(super) fn mean_speed<R: Real, const D: usize>(
    moved: &[u32],
    now: &[Aabb<R, D>],
    before: &[Aabb<R, D>],
) -> Option<f64> {
    let (mut sum, mut count) = (0.0, 0);
    // By slots and in their order, because threads note what has moved in another one.
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
                // One that has jumped far says nothing about the others.
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
        let fat = Foresight::new(Some(8)).fat_box(&at(0.0, 0.0), &at(-0.1, 0.0));
        assert!(fat.contains(&at(0.8, 0.0)) && !fat.contains(&at(-0.2, 0.0)));
        // Never by more than the size of the box and a quarter to each side.
        let fat = Foresight::new(Some(8)).fat_box(&at(0.0, 0.0), &at(-100.0, 0.0));
        assert_eq!(fat, Aabb::new([-0.25, -0.25], [2.25, 1.25]));
    }

    #[test]
    fn it_contains_the_box_whatever_the_numbers_are() {
        let numbers = [
            -f32::INFINITY,
            -1e30,
            0.0,
            1e-45,
            1.0,
            f32::MAX,
            f32::INFINITY,
        ];
        let boxes = numbers.map(|a| numbers.map(|b| Aabb::new([a, a], [b, b])));
        let boxes = boxes.as_flattened();
        for now in boxes.iter().filter(|b| b.is_valid()) {
            for (before, moves) in boxes.iter().flat_map(|b| [(b, 1), (b, u16::MAX)]) {
                let fat = Foresight::new(Some(moves)).fat_box(now, before);
                assert!(fat.contains(now) && fat.is_valid(), "{now:?} {before:?}");
            }
        }
    }

    #[test]
    fn what_is_new_or_rests_has_no_speed() {
        let now = [at(0.0, 0.0)];
        assert_eq!(mean_speed(&[0], &now, &[Aabb::ABSENT]), None);
        assert_eq!(mean_speed(&[0], &now, &now), None);
        assert_eq!(mean_speed(&[0], &now, &[at(-0.5, 0.0)]), Some(0.25));
    }

    #[test]
    fn it_goes_half_a_size_ahead_and_no_farther_than_the_longest() {
        let moves = |speed| Foresight::new(None).renewed(|| speed).moves;
        let speeds = [None, Some(1e-9), Some(0.1), Some(0.5), Some(0.51)];
        assert_eq!(speeds.map(moves), [FIRST, LONGEST, 5, 1, 0]);
    }

    #[test]
    fn what_was_shortened_grows_again_by_and_by() {
        let slow = |foresight: Foresight| foresight.renewed(|| Some(1e-9));
        let mut foresight = slow(Foresight::new(None));
        // From none as well.
        while foresight.moves > 0 {
            foresight.shorten();
        }
        let mut expected = 0;
        while expected < LONGEST {
            for _ in 0..CUT_RUNS {
                foresight = slow(foresight);
                assert_eq!(foresight.moves, expected);
            }
            foresight = slow(foresight);
            expected = (2 * expected).max(1);
            assert_eq!(foresight.moves, expected);
        }
    }
}
