//! Lists of boxes, which the families of inputs consist of.

use core::array::from_fn;

use crate::numbers::Number;
use crate::random::Random;
use unisize::Aabb;

/// The box at `mins` with these sides. Its `maxs` are rounded as in an engine.
pub(crate) fn sized<R: Number, const D: usize>(mins: [f64; D], sides: [f64; D]) -> Aabb<R, D> {
    let mins = mins.map(R::from_f64);
    Aabb::new(mins, from_fn(|k| mins[k] + R::from_f64(sides[k])))
}

/// The box with these bounds on each axis.
pub(crate) fn between<R: Number, const D: usize>(ends: [(R, R); D]) -> Aabb<R, D> {
    Aabb::new(ends.map(|(low, _)| low), ends.map(|(_, high)| high))
}

/// `n` boxes in random order. `each` returns the mins and the sides of a box.
pub(crate) fn list<R: Number, const D: usize>(
    seed: u64,
    n: usize,
    each: impl Fn(&mut Random, usize) -> ([f64; D], [f64; D]),
) -> Vec<Aabb<R, D>> {
    let mut random = Random::new(seed);
    let boxes = (0..n).map(|i| each(&mut random, i));
    let mut boxes: Vec<_> = boxes.map(|(mins, sides)| sized(mins, sides)).collect();
    random.shuffle(&mut boxes);
    boxes
}

/// Boxes with the given sides, uniform in a cube around the origin. The sum of their volumes is `density` times that of the cube.
pub(crate) fn scattered<R: Number, const D: usize>(
    seed: u64,
    density: f64,
    n: usize,
    sides: impl Fn(&mut Random, usize) -> [f64; D],
) -> Vec<Aabb<R, D>> {
    let mut random = Random::new(seed);
    let sides: Vec<_> = (0..n).map(|i| sides(&mut random, i)).collect();
    let volume: f64 = sides.iter().map(|s| s.iter().product::<f64>()).sum();
    let half = 0.5 * (volume / density).powf(1.0 / D as f64);
    let place = |sides| sized(random.place(-half, half), sides);
    sides.into_iter().map(place).collect()
}

/// `n` unit boxes, uniform in a cube of volume `n / density`.
pub(crate) fn uniform<R: Number, const D: usize>(
    seed: u64,
    n: usize,
    density: f64,
) -> Vec<Aabb<R, D>> {
    scattered(seed, density, n, |_, _| [1.0; D])
}

/// `n` copies of a unit box in each of `stacks` places that are far apart. The list alternates between the places.
pub(crate) fn coincident<R: Number, const D: usize>(n: usize, stacks: usize) -> Vec<Aabb<R, D>> {
    let at = |i: usize| [10.0 * (i % stacks) as f64; D];
    (0..n * stacks).map(|i| sized(at(i), [1.0; D])).collect()
}

/// `n` boxes with sides between 1 and `ratio`.
pub(crate) fn mixed_sizes<R: Number, const D: usize>(
    seed: u64,
    n: usize,
    ratio: f64,
) -> Vec<Aabb<R, D>> {
    scattered(seed, 0.5, n, |random, _| random.place(1.0, ratio))
}

/// [`uniform`] boxes of density 0.8 and side `scale`, moved by `offset` on every axis, and loosened by `margin`. If `offset` is large, the
/// sides and the margin round, possibly to 0.
pub(crate) fn scaled<R: Number, const D: usize>(
    seed: u64,
    n: usize,
    [scale, offset, margin]: [f64; 3],
) -> Vec<Aabb<R, D>> {
    let [scale, offset, margin] = [scale, offset, margin].map(R::from_f64);
    let moved = |x: R| x * scale + offset;
    let boxes = uniform(seed, n, 0.8).into_iter();
    let boxes =
        boxes.map(|b: Aabb<R, D>| Aabb::new(b.mins.map(moved), b.maxs.map(moved)).loosened(margin));
    boxes.collect()
}

/// The bounds of a box on one axis: it is 1 long, reaches to either infinity or to both, or has both bounds at the same infinity.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Side {
    Finite,
    Below,
    Above,
    Everywhere,
    AtNegative,
    AtPositive,
}

/// `n` unit boxes, of which `infinite` have the bounds of `sides` on each axis.
pub(crate) fn with_infinite<R: Number, const D: usize>(
    n: usize,
    infinite: usize,
    sides: impl Fn(&mut Random) -> [Side; D],
) -> Vec<Aabb<R, D>> {
    let mut random = Random::new(14);
    let [below, above] = [f64::NEG_INFINITY, f64::INFINITY].map(R::from_f64);
    let mut boxes = uniform(15, n, 0.5);
    for _ in 0..infinite {
        boxes.push(between(sides(&mut random).map(|side| {
            let at = R::from_f64(random.between(-12.0, 12.0));
            match side {
                Side::Finite => (at, at + R::from_f64(1.0)),
                Side::Below => (below, at),
                Side::Above => (at, above),
                Side::Everywhere => (below, above),
                Side::AtNegative => (below, below),
                Side::AtPositive => (above, above),
            }
        })));
    }
    random.shuffle(&mut boxes);
    boxes
}

/// Sorts the boxes by their `mins` on `axis`.
pub(crate) fn sorted<R: Number, const D: usize>(
    mut boxes: Vec<Aabb<R, D>>,
    axis: usize,
) -> Vec<Aabb<R, D>> {
    let compare = |a: R, b: R| a.partial_cmp(&b).expect("no coordinate is NaN");
    boxes.sort_by(|a, b| compare(a.mins[axis], b.mins[axis]));
    boxes
}
