//! How large boxes are: generators of boxes of mixed sizes, thin ones, flat ones and points.

use core::array::from_fn;

use crate::numbers::Number;
use unisize::Aabb;

use crate::placement::{scattered, sized};
use crate::random::Random;

/// `n` boxes, each side uniform in `1..ratio`.
pub(crate) fn mixed_sizes<R: Number, const D: usize>(
    seed: u64,
    n: usize,
    ratio: f64,
) -> Vec<Aabb<R, D>> {
    let mut random = Random::new(seed);
    let sides: Vec<_> = (0..n)
        .map(|_| from_fn(|_| random.between(1.0, ratio)))
        .collect();
    scattered(&mut random, &sides, 0.5)
}

/// `n` cubes whose side is log-uniform over `decades` powers of ten, centred on 1.
pub(crate) fn log_uniform_sizes<R: Number, const D: usize>(
    seed: u64,
    n: usize,
    decades: f64,
) -> Vec<Aabb<R, D>> {
    let mut random = Random::new(seed);
    let sides: Vec<_> = (0..n)
        .map(|_| [10_f64.powf(random.between(-0.5 * decades, 0.5 * decades)); D])
        .collect();
    scattered(&mut random, &sides, 0.5)
}

/// `n` unit boxes of which a `share` is `ratio` times as large.
pub(crate) fn few_large<R: Number, const D: usize>(
    seed: u64,
    n: usize,
    share: f64,
    ratio: f64,
) -> Vec<Aabb<R, D>> {
    let mut random = Random::new(seed);
    let sides: Vec<_> = (0..n)
        .map(|_| [if random.chance(share) { ratio } else { 1.0 }; D])
        .collect();
    scattered(&mut random, &sides, 1.0)
}

/// `n` unit boxes of which every `period`-th, from the first on, is `ratio` times as large: a sample that
/// takes one box in every few sees only these, or none.
pub(crate) fn large_by_turns<R: Number, const D: usize>(
    seed: u64,
    n: usize,
    period: usize,
    ratio: f64,
) -> Vec<Aabb<R, D>> {
    let side = |i: usize| if i % period == 0 { ratio } else { 1.0 };
    let sides: Vec<_> = (0..n).map(|i| [side(i); D]).collect();
    scattered(&mut Random::new(seed), &sides, 0.5)
}

/// `n` needles 100 times as long as thick, along `axis`, or each along an axis of its own.
pub(crate) fn needles<R: Number, const D: usize>(
    seed: u64,
    n: usize,
    axis: Option<usize>,
    density: f64,
) -> Vec<Aabb<R, D>> {
    let mut random = Random::new(seed);
    let sides: Vec<_> = (0..n)
        .map(|_| {
            let long = axis.unwrap_or_else(|| random.below(D));
            from_fn(|k| if k == long { 10.0 } else { 0.1 })
        })
        .collect();
    scattered(&mut random, &sides, density)
}

/// `n` wide plates piled along `axis`, a `pitch` apart, each 1 thick and moved a little sideways.
pub(crate) fn plates<R: Number, const D: usize>(
    seed: u64,
    n: usize,
    axis: usize,
    pitch: f64,
) -> Vec<Aabb<R, D>> {
    let mut random = Random::new(seed);
    let mut boxes: Vec<_> = (0..n)
        .map(|i| {
            let mut mins: [f64; D] = from_fn(|_| random.between(-1.0, 1.0));
            mins[axis] = pitch * i as f64;
            sized(mins, from_fn(|k| if k == axis { 1.0 } else { 500.0 }))
        })
        .collect();
    random.shuffle(&mut boxes);
    boxes
}

/// `n` points with whole coordinates in `0..extent`, so that many coincide.
pub(crate) fn points<R: Number, const D: usize>(
    seed: u64,
    n: usize,
    extent: i32,
) -> Vec<Aabb<R, D>> {
    let mut random = Random::new(seed);
    (0..n)
        .map(|_| sized(from_fn(|_| random.whole(0, extent - 1)), [0.0; D]))
        .collect()
}

/// `n` boxes without thickness on `axis`, where they lie on few different numbers, and 1 to 2 wide elsewhere.
pub(crate) fn flat<R: Number, const D: usize>(seed: u64, n: usize, axis: usize) -> Vec<Aabb<R, D>> {
    let mut random = Random::new(seed);
    (0..n)
        .map(|_| {
            let mut mins: [f64; D] = from_fn(|_| random.between(0.0, 20.0));
            let mut sides: [f64; D] = from_fn(|_| random.between(1.0, 2.0));
            mins[axis] = random.whole(-2, 2);
            sides[axis] = 0.0;
            sized(mins, sides)
        })
        .collect()
}

/// `n` boxes with whole corners in `0..extent` and sides of 0, 1 or 2: ties everywhere.
pub(crate) fn whole_corners<R: Number, const D: usize>(
    seed: u64,
    n: usize,
    extent: i32,
) -> Vec<Aabb<R, D>> {
    let mut random = Random::new(seed);
    (0..n)
        .map(|_| {
            sized(
                from_fn(|_| random.whole(0, extent - 1)),
                from_fn(|_| random.whole(0, 2)),
            )
        })
        .collect()
}
