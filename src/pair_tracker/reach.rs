//! How far a proxy may go before it must be searched for again.
//!
//! Searching is dear, and comparing two boxes that are known to be near each other is cheap. So each proxy has
//! a *reach* around its box, and what is searched for are pairs of reaches that overlap, the candidates. While
//! boxes stay inside of their reaches, only the candidates have to be looked at.
//!
//! Things keep going where they went: the reach is the box, drawn out in the direction of its last move as far
//! as it will get in a number of further moves, and by an eighth of that to all sides. A longer horizon means fewer searches
//! and more candidates. With `c` the cost of comparing one candidate and `K` that of searching for one box, a move
//! of `v` box sizes and `p` pairs a box, a move costs about `K / h + c · p · (1 + v · h)ᴰ` a box under a horizon of
//! `h` moves, and is least near `h = √(K / (c · D · p · v))`.

use crate::{Aabb, Real};

/// `K / c`: searching for a box costs about as much as comparing so many candidates.
const SEARCH_COST: f64 = 12.0;

/// How far the reach goes to all sides, as a part of how far it goes ahead: things never move quite straight.
const ASIDE: f64 = 0.125;

/// Moves farther than this, in box sizes, are not foreseen at all.
const TOO_FAST: f64 = 0.5;

/// The longest horizon: sooner or later things turn.
const LONGEST: f64 = 48.0;

/// Foresight does not pay if more than this share of all proxies leave their reaches in one update, because they
/// collide all the time, say.
const TOO_ERRATIC: f64 = 0.05;

/// Then there is none for so many full runs.
const PAUSE: u32 = 32;

/// How many of the moved are looked at, at most.
const SAMPLE: usize = 128;

/// The horizon while nothing has moved yet.
const UNKNOWN: f64 = 8.0;

/// For how many moves ahead a proxy is searched for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Horizon {
    moves: f64,
    /// For so many full runs it stays at 0.
    paused: u32,
}

impl Default for Horizon {
    fn default() -> Self {
        Self {
            moves: UNKNOWN,
            paused: 0,
        }
    }
}

impl Horizon {
    /// Suits it to these slots, which have moved, to this number of held pairs a proxy, and to the share of all
    /// proxies that have left their reaches in each of the updates since the last call.
    pub(super) fn adapt<R: Real, const D: usize>(
        &mut self,
        moved: &[u32],
        now: &[Aabb<R, D>],
        before: &[Aabb<R, D>],
        pairs_per_proxy: f64,
        escaping: f64,
    ) {
        if self.paused > 0 {
            self.paused -= 1;
        } else if escaping > TOO_ERRATIC {
            self.paused = PAUSE;
        }
        if self.paused > 0 {
            self.moves = 0.0;
        } else if let Some(speed) = mean_speed(moved, now, before) {
            let pairs = pairs_per_proxy.max(0.1);
            let best = (SEARCH_COST / (D as f64 * pairs * speed)).sqrt();
            self.moves = if speed < TOO_FAST {
                best.min(LONGEST)
            } else {
                0.0
            };
        }
    }

    /// The reach of a proxy that was at `before` and is at `now`. It contains `now`, whatever the numbers are.
    pub(super) fn reach<R: Real, const D: usize>(
        self,
        now: &Aabb<R, D>,
        before: &Aabb<R, D>,
    ) -> Aabb<R, D> {
        if self.moves == 0.0 || !before.is_valid() {
            return *now;
        }
        let moves = R::from_f64(self.moves);
        let [aside_share, quarter] = [ASIDE, 0.25].map(R::from_f64);
        let steps: [R; D] = core::array::from_fn(|k| step(now, before, k));
        let longest = steps
            .iter()
            .fold(R::ZERO, |m, &s| max(max(m, s), R::ZERO - s));
        let mut reach = *now;
        for k in 0..D {
            // No more than the size of the box, so that candidates are as few as pairs but for a factor.
            let size = now.maxs[k] - now.mins[k];
            let ahead = max(min(steps[k] * moves, size), R::ZERO - size);
            let aside = min(longest * moves * aside_share, size * quarter);
            reach.mins[k] = now.mins[k] + min(ahead, R::ZERO) - aside;
            reach.maxs[k] = now.maxs[k] + max(ahead, R::ZERO) + aside;
        }
        // It has a NaN if the boxes are infinite.
        if reach.contains(now) { reach } else { *now }
    }
}

/// How far slots have moved on each axis in box sizes, on average, by a sample; `None` if all are new or infinite.
fn mean_speed<R: Real, const D: usize>(
    moved: &[u32],
    now: &[Aabb<R, D>],
    before: &[Aabb<R, D>],
) -> Option<f64> {
    let (mut sum, mut count) = (0.0, 0);
    for &slot in moved.iter().step_by(moved.len() / SAMPLE + 1) {
        let (now, before) = (&now[slot as usize], &before[slot as usize]);
        for k in 0..D {
            let [size, step] = [now.maxs[k] - now.mins[k], step(now, before, k)].map(R::to_f64);
            let relative = (step / size).abs();
            if relative.is_finite() {
                // One that has been carried far off says nothing of the others.
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
        let reach = Horizon::default().reach(&at(0.0, 0.0), &at(-0.1, 0.0));
        assert!(reach.contains(&at(0.8, 0.0)) && !reach.contains(&at(-0.2, 0.0)));
        // Never by more than the size of the box and a quarter to each side.
        let reach = Horizon::default().reach(&at(0.0, 0.0), &at(-100.0, 0.0));
        assert_eq!(reach, Aabb::new([-0.25, -0.25], [2.25, 1.25]));
    }

    #[test]
    fn it_is_the_box_of_one_that_is_new() {
        let absent = Aabb::new([f32::NAN; 2], [f32::NAN; 2]);
        assert_eq!(
            Horizon::default().reach(&at(0.0, 0.0), &absent),
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
                        let reach = Horizon::default().reach(&now, &Aabb::new([c, d], [d, d]));
                        assert!(reach.contains(&now) && reach.is_valid(), "{now:?} {c} {d}");
                        count += 1;
                    }
                }
            }
        }
        assert!(count > 1000);
    }

    #[test]
    fn the_faster_the_shorter() {
        let before: Vec<_> = (0..50).map(|i| at(i as f32, 0.0)).collect();
        let slots: Vec<_> = (0..50).collect();
        let moves = |step: f32| {
            let now: Vec<_> = (0..50).map(|i| at(i as f32 + step, step)).collect();
            let mut horizon = Horizon::default();
            horizon.adapt(&slots, &now, &before, 1.0, 0.0);
            horizon.moves
        };
        assert_eq!(moves(0.001), LONGEST);
        assert!(moves(0.05) > moves(0.1) && moves(0.1) > 2.0);
        assert_eq!(moves(1.5), 0.0);
        let absent = vec![Aabb::new([f32::NAN; 2], [f32::NAN; 2]); 50];
        let mut horizon = Horizon::default();
        horizon.adapt(&slots, &before, &absent, 1.0, 0.0);
        assert_eq!(horizon, Horizon::default());
    }

    #[test]
    fn there_is_none_for_a_while_where_it_does_not_pay() {
        let [before, now] = [0.0, 0.1].map(|x| vec![at(x, x)]);
        let mut horizon = Horizon::default();
        let mut adapt = |escaping| {
            horizon.adapt(&[0], &now, &before, 1.0, escaping);
            horizon.moves
        };
        assert!(adapt(0.01) > 0.0);
        assert_eq!(adapt(0.5), 0.0);
        let pause = (0..1000).take_while(|_| adapt(0.0) == 0.0).count();
        assert_eq!(pause, PAUSE as usize - 1);
        assert!(adapt(0.01) > 0.0);
    }
}
