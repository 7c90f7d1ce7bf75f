//! The limits of numbers: generators at the limits of floating point, where a difference overflows, a margin
//! rounds away, or two numbers are equal without being identical.

use core::array::from_fn;

use crate::numbers::Number;
use unisize::Aabb;

use crate::placement::uniform;
use crate::random::Random;

/// [`uniform`] boxes of density 0.8, side `scale`, moved by `offset` on every axis, loosened by `margin`.
///
/// Where `offset` is large the sides round, to 0 in the end, and so does the margin.
pub(crate) fn scaled<R: Number, const D: usize>(
    seed: u64,
    n: usize,
    scale: f64,
    offset: f64,
    margin: f64,
) -> Vec<Aabb<R, D>> {
    let [scale, offset, margin] = [scale, offset, margin].map(R::from_f64);
    uniform(seed, n, 0.8)
        .into_iter()
        .map(|b: Aabb<R, D>| {
            let moved = |x: R| x * scale + offset;
            Aabb::new(b.mins.map(moved), b.maxs.map(moved)).loosened(margin)
        })
        .collect()
}

/// `n` unit boxes and one stray at `at`, `side` large, in the middle of the list.
pub(crate) fn with_stray<R: Number, const D: usize>(
    seed: u64,
    n: usize,
    at: [f64; D],
    side: f64,
) -> Vec<Aabb<R, D>> {
    let mut boxes = uniform(seed, n, 0.8);
    let mins = at.map(R::from_f64);
    let stray = Aabb::new(mins, mins.map(|x| x + R::from_f64(side)));
    boxes.insert(n / 2, stray);
    boxes
}

/// What a box does on one axis.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Side {
    /// It is 1 long.
    Finite,
    /// It reaches to negative infinity.
    Below,
    /// It reaches to infinity.
    Above,
    /// It reaches to both.
    Everywhere,
    /// Both its sides are negative infinity.
    AtNegative,
    /// Both its sides are infinity.
    AtPositive,
}

/// `n` unit boxes among which are `infinite` that do, on each axis, one of what `sides` lists, at random.
pub(crate) fn with_infinite<R: Number, const D: usize>(
    seed: u64,
    n: usize,
    infinite: usize,
    sides: &[Side],
) -> Vec<Aabb<R, D>> {
    let mut random = Random::new(seed);
    let mut boxes = uniform(seed + 1, n, 0.5);
    boxes.extend((0..infinite).map(|_| {
        infinite_box(
            from_fn(|_| R::from_f64(random.between(-12.0, 12.0))),
            from_fn(|_| random.pick(sides)),
        )
    }));
    random.shuffle(&mut boxes);
    boxes
}

/// `n` unit boxes among which are `slabs`: infinite on every axis but one.
pub(crate) fn with_slabs<R: Number, const D: usize>(
    seed: u64,
    n: usize,
    slabs: usize,
) -> Vec<Aabb<R, D>> {
    let mut random = Random::new(seed);
    let mut boxes = uniform(seed + 1, n, 0.5);
    boxes.extend((0..slabs).map(|_| {
        let mut sides = [Side::Everywhere; D];
        sides[random.below(D)] = Side::Finite;
        infinite_box(from_fn(|_| R::from_f64(random.between(-12.0, 12.0))), sides)
    }));
    random.shuffle(&mut boxes);
    boxes
}

/// The box that does on each axis what `sides` says, at the corner `at`.
fn infinite_box<R: Number, const D: usize>(at: [R; D], sides: [Side; D]) -> Aabb<R, D> {
    let ends: [(R, R); D] = from_fn(|k| match sides[k] {
        Side::Finite => (at[k], at[k] + R::from_f64(1.0)),
        Side::Below => (R::from_f64(f64::NEG_INFINITY), at[k]),
        Side::Above => (at[k], R::from_f64(f64::INFINITY)),
        Side::Everywhere => (R::from_f64(f64::NEG_INFINITY), R::from_f64(f64::INFINITY)),
        Side::AtNegative => (
            R::from_f64(f64::NEG_INFINITY),
            R::from_f64(f64::NEG_INFINITY),
        ),
        Side::AtPositive => (R::from_f64(f64::INFINITY), R::from_f64(f64::INFINITY)),
    });
    Aabb::new(ends.map(|(low, _)| low), ends.map(|(_, high)| high))
}

/// `n` boxes with every coordinate one of `alphabet`, so that they meet exactly or not at all.
pub(crate) fn from_alphabet<R: Number, const D: usize>(
    seed: u64,
    n: usize,
    alphabet: &[R],
) -> Vec<Aabb<R, D>> {
    let mut random = Random::new(seed);
    (0..n)
        .map(|_| {
            let ends: [(R, R); D] = from_fn(|_| {
                let (a, b) = (random.pick(alphabet), random.pick(alphabet));
                // Equal zeros of different sign are left in either order: `mins = +0, maxs = -0` is valid.
                if a <= b { (a, b) } else { (b, a) }
            });
            Aabb::new(ends.map(|(low, _)| low), ends.map(|(_, high)| high))
        })
        .collect()
}

/// `n` boxes whose coordinates are log-uniform over everything that is a number, and of either sign.
pub(crate) fn of_all_magnitudes<R: Number, const D: usize>(seed: u64, n: usize) -> Vec<Aabb<R, D>> {
    let mut random = Random::new(seed);
    let decades = R::LARGEST.to_f64().log10();
    let numbers: Vec<R> = (0..2 * D * n)
        .map(|_| {
            let size = 10_f64.powf(random.between(-decades, decades));
            R::from_f64(if random.chance(0.5) { -size } else { size })
        })
        .collect();
    from_alphabet(seed, n, &numbers)
}
