//! How far ahead a proxy's fat box is drawn.
//!
//! Searching is expensive, and comparing two boxes that are known to be near each other is cheap. So each proxy has a
//! *fat box* around its box, and the search is for overlapping pairs of fat boxes, the candidates. While boxes stay
//! inside their fat boxes, only the candidates have to be looked at.
//!
//! Things keep going where they went: the fat box is the box, drawn out in the direction of its last move as far as it
//! will get in a number of further moves, and by a skin to all sides. A longer horizon means fewer searches and more
//! candidates. If searching for one box costs `K` and comparing one candidate costs `c`, an update under a horizon of
//! `h` moves costs about `K / h + c · e(h)` per box, where `e(h)` is the number of candidates per box that are not
//! held. Those are counted, and grow about as `h` does, so the next horizon is near `√(K / c · h / e(h))`. The first
//! one goes by a model: with moves of `v` box sizes and `p` pairs per box, `e(h)` is near `p · D · v · h`.

use crate::tuning::update::{
    FIRST_FORESIGHT, LONGEST_FORESIGHT, PAUSES, SEARCH_COST, SHORTENING, SKIN, SPEED_SAMPLE,
    TOO_DEAR, TOO_FAST, WIDEST_SKIN,
};
use crate::{Aabb, Real};

/// For how many moves ahead a proxy is searched for.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub(crate) struct Horizon {
    moves: f64,
    /// Whether the fat boxes of the last full run were drawn by it.
    is_tried: bool,
    /// For how many more full runs it stays at 0.
    paused: u32,
    /// For how many it will stay at 0 the next time that it does not pay.
    next_pause: u32,
}

/// What a horizon has cost and yielded.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Experience {
    /// Held pairs per proxy.
    pub(super) pairs: f64,
    /// Candidates per proxy that are not held.
    pub(super) excess: f64,
    /// What searching has cost in each update, in full runs; `None` if nothing was searched for yet.
    pub(super) cost: Option<f64>,
}

impl Default for Horizon {
    fn default() -> Self {
        Self::FIRST
    }
}

impl Horizon {
    /// The horizon while nothing has moved yet.
    pub(super) const FIRST: Self = Self {
        moves: FIRST_FORESIGHT,
        is_tried: false,
        paused: 0,
        next_pause: PAUSES[0],
    };

    /// The next horizon in `D` dimensions, by the experience with this one and by how fast things move on average, in
    /// box sizes per move; `None` if nothing has moved that was there before.
    pub(super) fn adapted<const D: usize>(
        mut self,
        speed: Option<f64>,
        experience: Experience,
    ) -> Self {
        if self.paused > 0 {
            self.paused -= 1;
        } else if let (true, Some(cost)) = (self.is_tried, experience.cost) {
            if cost > TOO_DEAR {
                self.pause();
            } else {
                self.next_pause = PAUSES[0];
            }
        }
        self.is_tried = speed.is_some() && self.paused == 0;
        let Some(speed) = speed else {
            return self;
        };
        if self.paused > 0 || speed > TOO_FAST {
            self.moves = 0.0;
        } else if self.moves > 0.0 && experience.excess > 0.0 {
            let best = (SEARCH_COST * self.moves / experience.excess).sqrt();
            // Half way, by ratio, so that it does not oscillate.
            self.moves = (self.moves * best).sqrt().min(LONGEST_FORESIGHT);
        } else {
            let growth = D as f64 * experience.pairs.max(0.1) * speed;
            self.moves = (SEARCH_COST / growth).sqrt().min(LONGEST_FORESIGHT);
        }
        self
    }

    /// This number of moves, until another one takes its place.
    pub(super) fn fixed(moves: u16) -> Self {
        Self {
            moves: f64::from(moves).min(LONGEST_FORESIGHT),
            ..Self::default()
        }
    }

    /// The moves, rounded.
    pub(super) fn moves(self) -> u32 {
        self.moves.round() as u32
    }

    /// Stops looking ahead for a while.
    fn pause(&mut self) {
        self.paused = self.next_pause;
        self.next_pause = PAUSES[1].min(2 * self.next_pause);
        self.moves = 0.0;
    }

    /// Looks less far ahead, because there are too many candidates.
    pub(super) fn shorten(&mut self) {
        let [divisor, least] = SHORTENING;
        self.moves /= divisor;
        if self.moves < least {
            self.pause();
        }
    }

    /// Whether there can be such a horizon.
    #[cfg(feature = "serde-serialize")]
    pub(super) fn is_sound(&self) -> bool {
        let [shortest, longest] = PAUSES;
        // False for NaN as well.
        let are_moves = (0.0..=LONGEST_FORESIGHT).contains(&self.moves);
        are_moves && self.paused <= longest && (shortest..=longest).contains(&self.next_pause)
    }

    /// Whether it looks ahead at all.
    pub(super) fn is_any(&self) -> bool {
        self.moves > 0.0
    }

    /// The fat box of a proxy that was at `before` and is at `now`. It contains `now`, for any numbers.
    pub(super) fn fat_box<R: Real, const D: usize>(
        self,
        now: &Aabb<R, D>,
        before: &Aabb<R, D>,
    ) -> Aabb<R, D> {
        if self.moves == 0.0 || !before.is_valid() {
            return *now;
        }
        let moves = R::from_f64(self.moves);
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

/// How far slots have moved on each axis in box sizes, on average, by a sample; `None` if all are new or infinite.
pub(super) fn mean_speed<R: Real, const D: usize>(
    moved: &[u32],
    now: &[Aabb<R, D>],
    before: &[Aabb<R, D>],
) -> Option<f64> {
    let (mut sum, mut count) = (0.0, 0);
    for &slot in moved.iter().step_by(moved.len() / SPEED_SAMPLE + 1) {
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
    (count > 0).then(|| sum / f64::from(count))
}

/// How far the centre has moved along an axis.
#[inline(always)]
fn step<R: Real, const D: usize>(now: &Aabb<R, D>, before: &Aabb<R, D>, axis: usize) -> R {
    let sum = (now.mins[axis] - before.mins[axis]) + (now.maxs[axis] - before.maxs[axis]);
    sum * R::from_f64(0.5)
}

/// The second one if they cannot be compared.
#[inline(always)]
fn min<R: Real>(a: R, b: R) -> R {
    if a < b { a } else { b }
}

/// The second one if they cannot be compared.
#[inline(always)]
fn max<R: Real>(a: R, b: R) -> R {
    if a > b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: f32, y: f32) -> Aabb<f32, 2> {
        Aabb::new([x, y], [x + 1.0, y + 1.0])
    }

    #[test]
    fn it_lies_ahead() {
        let fat = Horizon::default().fat_box(&at(0.0, 0.0), &at(-0.1, 0.0));
        assert!(fat.contains(&at(0.8, 0.0)) && !fat.contains(&at(-0.2, 0.0)));
        // Never by more than the size of the box and a quarter to each side.
        let fat = Horizon::default().fat_box(&at(0.0, 0.0), &at(-100.0, 0.0));
        assert_eq!(fat, Aabb::new([-0.25, -0.25], [2.25, 1.25]));
    }

    #[test]
    fn it_is_the_box_of_one_that_is_new() {
        let absent = Aabb::new([f32::NAN; 2], [f32::NAN; 2]);
        assert_eq!(
            Horizon::default().fat_box(&at(0.0, 0.0), &absent),
            at(0.0, 0.0)
        );
    }

    #[test]
    fn it_contains_the_box_whatever_the_numbers_are() {
        let numbers = [
            0.0,
            1.0,
            -1e30,
            1e38,
            f32::MAX,
            f32::INFINITY,
            -f32::INFINITY,
            1e-45,
        ];
        let mut count = 0;
        for &a in &numbers {
            for &b in numbers.iter().filter(|&&b| a <= b) {
                for &c in &numbers {
                    for &d in numbers.iter().chain(&[f32::NAN]) {
                        let now = Aabb::new([a, a], [b, b]);
                        let fat = Horizon::default().fat_box(&now, &Aabb::new([c, d], [d, d]));
                        assert!(fat.contains(&now) && fat.is_valid(), "{now:?} {c} {d}");
                        count += 1;
                    }
                }
            }
        }
        assert!(count > 1000);
    }

    fn adapted(horizon: Horizon, step: f32, experience: Experience) -> Horizon {
        let before: Vec<_> = (0..50).map(|i| at(i as f32, 0.0)).collect();
        let now: Vec<_> = (0..50).map(|i| at(i as f32 + step, step)).collect();
        let slots: Vec<_> = (0..50).collect();
        horizon.adapted::<2>(mean_speed(&slots, &now, &before), experience)
    }

    #[test]
    fn the_faster_the_shorter() {
        let first = |step| {
            let experience = Experience {
                pairs: 1.0,
                ..Experience::default()
            };
            adapted(Horizon::default(), step, experience).moves
        };
        assert_eq!(first(0.001), LONGEST_FORESIGHT);
        assert!(first(0.05) > first(0.1) && first(0.1) > 2.0);
        assert_eq!(first(1.5), 0.0);
    }

    #[test]
    fn it_finds_the_best_where_candidates_grow_with_it() {
        let mut horizon = Horizon::default();
        for _ in 0..20 {
            let experience = Experience {
                pairs: 1.0,
                excess: 0.04 * horizon.moves,
                cost: None,
            };
            horizon = adapted(horizon, 0.05, experience);
        }
        assert!((horizon.moves - 20.0).abs() < 0.1, "{horizon:?}");
    }

    #[test]
    fn what_is_new_says_nothing() {
        let now = [at(0.0, 0.0)];
        let absent = [Aabb::new([f32::NAN; 2], [f32::NAN; 2])];
        assert_eq!(mean_speed(&[0], &now, &absent), None);
        let horizon = Horizon::FIRST.adapted::<2>(None, Experience::default());
        assert_eq!(horizon, Horizon::FIRST);
    }

    #[test]
    fn there_is_none_for_a_while_where_it_does_not_pay() {
        let mut horizon = Horizon::default();
        let mut adapt = |cost| {
            let experience = Experience {
                pairs: 1.0,
                cost,
                ..Experience::default()
            };
            horizon = adapted(horizon, 0.1, experience);
            horizon.moves
        };
        assert!(adapt(None) > 0.0);
        assert!(adapt(Some(0.1)) > 0.0);
        assert_eq!(adapt(Some(0.9)), 0.0);
        let mut pause = |cost| (0..1000).take_while(|_| adapt(Some(cost)) == 0.0).count();
        // It is tried again for one run each time, and given up for longer.
        assert_eq!([(); 6].map(|()| pause(1.0)), [7, 16, 32, 64, 128, 128]);
        assert_eq!(pause(0.1), 0);
        assert_eq!(pause(1.0), 8);
    }
}
