//! How far a proxy may go before it must be searched for again.
//!
//! Searching is dear, and comparing two boxes that are known to be near each other is cheap. So each proxy has
//! a *reach* around its box, and what is searched for are pairs of reaches that overlap, the candidates. While
//! boxes stay inside of their reaches, only the candidates have to be looked at.
//!
//! Things keep going where they went: the reach is the box, drawn out in the direction of its last move as far
//! as it will get in a number of further moves, and a little to all sides. A longer horizon means fewer searches
//! and more candidates. With `c` the cost of comparing one candidate and `K` that of searching for one box, a move
//! of `v` box sizes and `p` pairs a box, a move costs about `K / h + c · p · (1 + v · h)ᴰ` a box under a horizon of
//! `h` moves, and is least near `h = √(K / (c · D · p · v))`.

use super::moved_sample;
use crate::{Aabb, Real};

/// `K / c`: searching for a box costs about as much as comparing so many candidates.
const SEARCH_COST: f64 = 12.0;

/// Moves farther than this, in box sizes, are not foreseen at all.
const TOO_FAST: f64 = 0.5;

/// The longest horizon: sooner or later things turn.
const LONGEST: f64 = 24.0;

/// The horizon while nothing has moved yet.
const UNKNOWN: f64 = 8.0;

/// For how many moves ahead a proxy is searched for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Horizon(f64);

impl Default for Horizon {
    fn default() -> Self {
        Self(UNKNOWN)
    }
}

impl Horizon {
    /// The horizon that suits these slots, which have moved, and this number of held pairs a proxy.
    pub(super) fn choose<R: Real, const D: usize>(
        moved: &[u32],
        now: &[Aabb<R, D>],
        before: &[Aabb<R, D>],
        pairs_per_proxy: f64,
    ) -> Option<Self> {
        let (mut moves, mut count) = (0.0, 0);
        for slot in moved_sample(moved) {
            let (now, before) = (&now[slot as usize], &before[slot as usize]);
            for k in 0..D {
                let [size, step] = [now.maxs[k] - now.mins[k], step(now, before, k)].map(R::to_f64);
                let relative = (step / size).abs();
                // Neither new nor infinite ones.
                if relative.is_finite() {
                    // One that has been carried far off says nothing of the others.
                    moves += relative.min(1.0);
                    count += 1;
                }
            }
        }
        if count == 0 {
            return None;
        }
        let speed = moves / f64::from(count);
        if speed > TOO_FAST {
            return Some(Self(0.0));
        }
        let pairs = pairs_per_proxy.max(0.25);
        let best = (SEARCH_COST / (D as f64 * pairs * speed)).sqrt();
        Some(Self(best.min(LONGEST)))
    }

    /// The reach of a proxy that was at `before` and is at `now`. It contains `now`, whatever the numbers are.
    pub(super) fn reach<R: Real, const D: usize>(
        self,
        now: &Aabb<R, D>,
        before: &Aabb<R, D>,
    ) -> Aabb<R, D> {
        if self.0 == 0.0 || !before.is_valid() {
            return *now;
        }
        let moves = R::from_f64(self.0);
        let [half, quarter] = [0.5, 0.25].map(R::from_f64);
        let steps: [R; D] = core::array::from_fn(|k| step(now, before, k));
        let longest = steps
            .iter()
            .fold(R::ZERO, |m, &s| max(max(m, s), R::ZERO - s));
        let mut reach = *now;
        for k in 0..D {
            // No more than the size of the box, so that candidates are as few as pairs but for a factor.
            let size = now.maxs[k] - now.mins[k];
            let ahead = max(min(steps[k] * moves, size), R::ZERO - size);
            let aside = min(longest * half, size * quarter);
            reach.mins[k] = now.mins[k] + min(ahead, R::ZERO) - aside;
            reach.maxs[k] = now.maxs[k] + max(ahead, R::ZERO) + aside;
        }
        // It has a NaN if the boxes are infinite.
        if reach.contains(now) { reach } else { *now }
    }
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
        let reach = Horizon(8.0).reach(&at(0.0, 0.0), &at(-0.1, 0.0));
        assert!(reach.contains(&at(0.8, 0.0)) && !reach.contains(&at(-0.1, 0.0)));
        // Never by more than the size of the box and a quarter to each side.
        let reach = Horizon(8.0).reach(&at(0.0, 0.0), &at(-100.0, 0.0));
        assert_eq!(reach, Aabb::new([-0.25, -0.25], [2.25, 1.25]));
    }

    #[test]
    fn it_is_the_box_of_one_that_is_new() {
        let absent = Aabb::new([f32::NAN; 2], [f32::NAN; 2]);
        assert_eq!(Horizon(8.0).reach(&at(0.0, 0.0), &absent), at(0.0, 0.0));
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
                        let reach = Horizon(8.0).reach(&now, &Aabb::new([c, d], [d, d]));
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
        let horizon = |step: f32| {
            let now: Vec<_> = (0..50).map(|i| at(i as f32 + step, step)).collect();
            Horizon::choose(&slots, &now, &before, 1.0).map_or(f64::NAN, |horizon| horizon.0)
        };
        assert_eq!(horizon(0.001), LONGEST);
        assert!(horizon(0.05) > horizon(0.1) && horizon(0.1) > 2.0);
        assert_eq!(horizon(1.5), 0.0);
        let absent = vec![Aabb::new([f32::NAN; 2], [f32::NAN; 2]); 50];
        assert_eq!(Horizon::choose(&slots, &before, &absent, 1.0), None);
    }
}
