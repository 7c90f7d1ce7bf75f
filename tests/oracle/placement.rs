//! Where boxes lie: generators of boxes of about one size, in every arrangement that a kernel may treat specially.

use core::array::from_fn;

use crate::numbers::Number;
use unisize::Aabb;

use crate::numbers::stepped;
use crate::random::Random;

/// The box at `mins` with these sides. The far corner is rounded as an engine would round it.
pub(crate) fn sized<R: Number, const D: usize>(mins: [f64; D], sides: [f64; D]) -> Aabb<R, D> {
    let mins = mins.map(R::from_f64);
    Aabb::new(mins, from_fn(|k| mins[k] + R::from_f64(sides[k])))
}

/// Boxes with the given sides, uniform in a cube around the origin whose volume makes the sum of theirs
/// `density` times as large.
pub(crate) fn scattered<R: Number, const D: usize>(
    random: &mut Random,
    sides: &[[f64; D]],
    density: f64,
) -> Vec<Aabb<R, D>> {
    let volume: f64 = sides.iter().map(|s| s.iter().product::<f64>()).sum();
    let half = 0.5 * (volume / density).powf(1.0 / D as f64);
    sides
        .iter()
        .map(|&sides| sized(from_fn(|_| random.between(-half, half)), sides))
        .collect()
}

/// `n` unit boxes, uniform in a cube `n / density` in volume.
pub(crate) fn uniform<R: Number, const D: usize>(
    seed: u64,
    n: usize,
    density: f64,
) -> Vec<Aabb<R, D>> {
    scattered(&mut Random::new(seed), &vec![[1.0; D]; n], density)
}

/// `clusters` dense heaps of `each` unit boxes, neighbours `distance` apart on a sparse lattice.
pub(crate) fn clustered<R: Number, const D: usize>(
    seed: u64,
    clusters: usize,
    each: usize,
    distance: f64,
) -> Vec<Aabb<R, D>> {
    let mut random = Random::new(seed);
    let mut boxes = Vec::new();
    for _ in 0..clusters {
        let centre: [f64; D] = from_fn(|_| distance * random.whole(-5, 5));
        boxes.extend(
            (0..each).map(|_| sized(from_fn(|k| centre[k] + random.between(-1.0, 1.0)), [1.0; D])),
        );
    }
    random.shuffle(&mut boxes);
    boxes
}

/// `n` copies of a unit box in each of `stacks` places, the places far from one another, copies alternating.
pub(crate) fn coincident<R: Number, const D: usize>(n: usize, stacks: usize) -> Vec<Aabb<R, D>> {
    (0..n * stacks)
        .map(|i| sized([10.0 * (i % stacks) as f64; D], [1.0; D]))
        .collect()
}

/// How the sides of neighbours in a [`lattice`] meet.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Meet {
    /// In the same coordinate: they touch.
    Exactly,
    /// Each box ends one unit in the last place before the next begins: they do not touch.
    Short,
    /// Each box ends one unit in the last place after the next begins: they overlap, barely.
    Over,
    /// Each coordinate is moved by -1, 0 or 1 unit in the last place.
    Jittered,
}

/// `per_axis` boxes along each axis, side by side, around the origin, in random order.
///
/// Both sides of a face are computed in the same way, so that they are equal for any `pitch`.
pub(crate) fn lattice<R: Number, const D: usize>(
    seed: u64,
    per_axis: usize,
    pitch: f64,
    meet: Meet,
) -> Vec<Aabb<R, D>> {
    let mut random = Random::new(seed);
    let half = per_axis as i64 / 2;
    let mut boxes: Vec<_> = (0..per_axis.pow(D as u32))
        .map(|i| {
            let cell: [i64; D] = from_fn(|k| (i / per_axis.pow(k as u32) % per_axis) as i64 - half);
            let mut jitter = || random.below(3) as i32 - 1;
            let (low, high): ([i32; D], [i32; D]) = match meet {
                Meet::Exactly => ([0; D], [0; D]),
                Meet::Short => ([0; D], [-1; D]),
                Meet::Over => ([0; D], [1; D]),
                Meet::Jittered => (from_fn(|_| jitter()), from_fn(|_| jitter())),
            };
            let side = |cell: i64, ulps| stepped(R::from_f64(cell as f64 * pitch), ulps);
            Aabb::new(
                from_fn(|k| side(cell[k], low[k])),
                from_fn(|k| side(cell[k] + 1, high[k])),
            )
        })
        .collect();
    random.shuffle(&mut boxes);
    boxes
}

/// `n` unit boxes uniform on a line along `axis`: on the other axes all begin at the same number.
pub(crate) fn on_line<R: Number, const D: usize>(
    seed: u64,
    n: usize,
    axis: usize,
) -> Vec<Aabb<R, D>> {
    let mut random = Random::new(seed);
    (0..n)
        .map(|_| {
            let along = random.between(0.0, 2.0 * n as f64);
            sized(from_fn(|k| if k == axis { along } else { 3.25 }), [1.0; D])
        })
        .collect()
}

/// A pile of `n` unit boxes along `axis`, each nearly on its neighbour, moved a little on the other axes.
pub(crate) fn in_column<R: Number, const D: usize>(
    seed: u64,
    n: usize,
    axis: usize,
) -> Vec<Aabb<R, D>> {
    let mut random = Random::new(seed);
    let mut boxes: Vec<_> = (0..n)
        .map(|i| {
            let mut mins: [f64; D] = from_fn(|_| random.between(-0.1, 0.1));
            mins[axis] += i as f64;
            sized(mins, [1.0; D])
        })
        .collect();
    random.shuffle(&mut boxes);
    boxes
}

/// `n` unit boxes uniform on the plane across `axis`, where all begin at the same number.
pub(crate) fn on_plane<R: Number, const D: usize>(
    seed: u64,
    n: usize,
    axis: usize,
) -> Vec<Aabb<R, D>> {
    let mut random = Random::new(seed);
    let extent = (2.0 * n as f64).powf(1.0 / (D as f64 - 1.0));
    (0..n)
        .map(|_| {
            let mut mins: [f64; D] = from_fn(|_| random.between(0.0, extent));
            mins[axis] = -7.5;
            sized(mins, [1.0; D])
        })
        .collect()
}

/// `n` unit boxes uniform on a diagonal through the origin; bit `k` of `mirrored` turns axis `k` round.
pub(crate) fn on_diagonal<R: Number, const D: usize>(
    seed: u64,
    n: usize,
    mirrored: usize,
) -> Vec<Aabb<R, D>> {
    let mut random = Random::new(seed);
    (0..n)
        .map(|_| {
            let along = random.between(-0.5 * n as f64, 0.5 * n as f64);
            let turned = |k: usize| mirrored >> k & 1 == 1;
            sized(
                from_fn(|k| if turned(k) { -along } else { along }),
                [1.0; D],
            )
        })
        .collect()
}
