//! Named inputs, in families. `limits` has those at the limits of floating point.
//!
//! Lists have a few hundred boxes, because the oracle compares all pairs.

use core::array::from_fn;

use crate::arrangements::HardBoxes;
use crate::boxes::{self, list, scattered, uniform};
use crate::limits::{far_from_origin, infinite, scales, strays};
use crate::numbers::{Number, stepped};
use crate::random::Random;
use unisize::Aabb;

/// A list of boxes, and its name for messages.
pub(crate) struct Input<R, const D: usize> {
    pub(crate) name: String,
    pub(crate) boxes: Vec<Aabb<R, D>>,
}

/// The inputs of one kind.
pub(crate) type Family<R, const D: usize> = Vec<Input<R, D>>;

/// All inputs of all families.
pub(crate) fn all<R: Number, const D: usize>() -> Family<R, D> {
    let families: [fn() -> Family<R, D>; 14] = [
        uniform_boxes,
        hard_boxes,
        coincident,
        touching,
        points_and_flat,
        scales,
        far_from_origin,
        strays,
        infinite,
        mixed_sizes,
        plates,
        counts,
        sorted,
        ties,
    ];
    let mut inputs: Vec<_> = families.into_iter().flat_map(|family| family()).collect();
    let few = inputs
        .iter()
        .flat_map(|input| input.boxes.iter().rev().take(5));
    let few = few.copied().collect();
    inputs.push(input("a few boxes of each input", few));
    inputs
}

pub(crate) fn input<R, const D: usize>(
    name: impl Into<String>,
    boxes: Vec<Aabb<R, D>>,
) -> Input<R, D> {
    let name = name.into();
    Input { name, boxes }
}

/// One input for each value.
pub(crate) fn each<T: Copy, R, const D: usize>(
    of: impl IntoIterator<Item = T>,
    name: impl Fn(T) -> String,
    boxes: impl Fn(T) -> Vec<Aabb<R, D>>,
) -> Family<R, D> {
    let of = of.into_iter();
    of.map(|it| input(name(it), boxes(it))).collect()
}

/// One input for each axis.
fn per_axis<R, const D: usize>(
    name: &str,
    boxes: impl Fn(usize) -> Vec<Aabb<R, D>>,
) -> Family<R, D> {
    each(0..D, |axis| format!("{name}, axis {axis}"), boxes)
}

/// Uniformly distributed unit boxes, from sparse to dense.
pub(crate) fn uniform_boxes<R: Number, const D: usize>() -> Family<R, D> {
    let densities = [0.01, 0.1, 0.3, 0.8, 1.5, 3.0];
    let pairs = densities.into_iter().flat_map(|it| [(100, it), (1000, it)]);
    each(
        pairs.chain([(3000, 0.5)]),
        |(n, density)| format!("uniform, n = {n}, density {density}"),
        |(n, density)| uniform(n as u64, n, density),
    )
}

/// The arrangements of `HardBoxes`, with the axes rotated, and every second one mirrored.
pub(crate) fn hard_boxes<R: Number, const D: usize>() -> Family<R, D> {
    let kinds = HardBoxes::ALL.into_iter();
    each(
        kinds.flat_map(|kind| (0..D).map(move |axis| (kind, axis))),
        |(kind, axis)| format!("{}, axis {axis} as the first", kind.name()),
        |(kind, axis)| {
            let turned = |[mins, maxs]: [[f32; D]; 2]| {
                boxes::between(from_fn(|k| {
                    let from = (k + axis) % D;
                    let side = [mins[from], maxs[from]].map(|x| R::from_f64(x.into()));
                    match from % 2 == 1 {
                        true => (R::from_f64(0.0) - side[1], R::from_f64(0.0) - side[0]),
                        false => (side[0], side[1]),
                    }
                }))
            };
            let boxes = kind.boxes(600, 7).into_iter();
            boxes.map(turned).collect()
        },
    )
}

/// Many copies of the same box.
pub(crate) fn coincident<R: Number, const D: usize>() -> Family<R, D> {
    each(
        [(300, 1), (150, 2), (3, 100)],
        |(n, stacks)| format!("{n} boxes in each of {stacks} stacks"),
        |(n, stacks)| boxes::coincident(n, stacks),
    )
}

/// Adjacent boxes that share faces, edges and corners, or that miss or overlap by one or several units in the last place. Both sides of a face
/// are computed in the same way, so that they are equal for any pitch.
pub(crate) fn touching<R: Number, const D: usize>() -> Family<R, D> {
    let count = if D == 2 { 24_usize } else { 8 };
    let lattice = |(pitch, ulps): (f64, Option<i32>)| {
        let mut random = Random::new(3);
        let side = |cell: i64, ulps| stepped(R::from_f64(cell as f64 * pitch), ulps);
        let cells = (0..count.pow(D as u32)).map(|i| {
            boxes::between(from_fn(|k| {
                let cell = (i / count.pow(k as u32) % count) as i64 - count as i64 / 2;
                let jitter = [(); 2].map(|()| random.below(3) as i32 - 1);
                let [low, high] = ulps.map_or(jitter, |ulps| [0, ulps]);
                (side(cell, low), side(cell + 1, high))
            }))
        });
        let mut boxes: Vec<_> = cells.collect();
        random.shuffle(&mut boxes);
        boxes
    };
    let pitches = [1.0, 0.1, 3.7].into_iter();
    each(
        pitches.flat_map(|pitch| [Some(0), Some(-1), Some(1), None].map(|ulps| (pitch, ulps))),
        |(pitch, ulps)| format!("lattice, pitch {pitch}, meeting at {ulps:?} (or random) ulps"),
        lattice,
    )
}

/// Boxes without extent on all axes, many of them in one place, or without extent on one axis.
pub(crate) fn points_and_flat<R: Number, const D: usize>() -> Family<R, D> {
    let mut family = per_axis("flat", |axis| {
        list(8, 400, |random, _| {
            let mut mins: [f64; D] = random.place(0.0, 20.0);
            let mut sides: [f64; D] = random.place(1.0, 2.0);
            (mins[axis], sides[axis]) = (random.whole(-2, 2), 0.0);
            (mins, sides)
        })
    });
    family.extend(each(
        [1, 4, 20, 1000],
        |extent| format!("points, {extent} per axis"),
        |extent| {
            list(9, 300, |random, _| {
                (from_fn(|_| random.whole(0, extent - 1)), [0.0; D])
            })
        },
    ));
    family
}

/// Boxes of different sizes.
pub(crate) fn mixed_sizes<R: Number, const D: usize>() -> Family<R, D> {
    let mut family = each(
        [1.5, 1000.0],
        |ratio| format!("sides from 1 to {ratio}"),
        |ratio| boxes::mixed_sizes(16, 800, ratio),
    );
    family.extend(each(
        [(0.01, 1e4), (0.5, 100.0)],
        |(share, ratio)| format!("a share of {share} that is {ratio} times as large"),
        |(share, ratio)| {
            scattered(18, 1.0, 1000, |random, _| {
                [if random.chance(share) { ratio } else { 1.0 }; D]
            })
        },
    ));
    let decades = scattered(17, 0.5, 800, |random, _| {
        [10_f64.powf(random.between(-15.0, 15.0)); D]
    });
    family.push(input("cubes of sides over 30 decades", decades));
    // A sample of every n-th box has only large boxes, or none.
    family.extend(each(
        [2, 3, 4],
        |period| format!("one box in {period} 50 times as large, by turns"),
        |period| {
            scattered(32, 0.5, 1200, |_, i| {
                [if i % period == 0 { 50.0 } else { 1.0 }; D]
            })
        },
    ));
    let mut boxes = boxes::coincident(8, 60);
    boxes.extend(boxes::mixed_sizes::<R, D>(34, 40, 1e6));
    family.push(input("stacks among boxes of all sizes", boxes));
    family
}

/// Wide plates stacked along each axis: apart, touching and overlapping.
pub(crate) fn plates<R: Number, const D: usize>() -> Family<R, D> {
    each(
        (0..D).flat_map(|axis| [1.25, 1.0, 0.25].map(|pitch| (axis, pitch))),
        |(axis, pitch)| format!("plates, pitch {pitch}, axis {axis}"),
        |(axis, pitch)| {
            list(20, 300, |random, i| {
                let mut mins: [f64; D] = random.place(-1.0, 1.0);
                mins[axis] = pitch * i as f64;
                (mins, from_fn(|k| if k == axis { 1.0 } else { 500.0 }))
            })
        },
    )
}

/// Lists with lengths around the powers of two, at which blocks, lanes and words end.
pub(crate) fn counts<R: Number, const D: usize>() -> Family<R, D> {
    let around = |bits: u32| (1 << bits) - 1..=(1 << bits) + 1;
    let counts = || (0..7).chain((3..=12).flat_map(around));
    let few = || counts().filter(|&n| n < 300);
    let mut family = each(counts(), |n| format!("n = {n}"), |n| uniform(26, n, 0.8));
    let name = |n| format!("n = {n}, coincident");
    family.extend(each(few(), name, |n| boxes::coincident(n, 1)));
    family
}

/// Lists that are sorted, reversed, or sorted except for a few neighbours, as from one frame to the next.
pub(crate) fn sorted<R: Number, const D: usize>() -> Family<R, D> {
    let sorted = |axis| boxes::sorted(uniform(28, 500, 0.8), axis);
    let mut family = per_axis("sorted", sorted);
    family.extend(per_axis("reversed", |axis| {
        sorted(axis).into_iter().rev().collect()
    }));
    family.extend(per_axis("almost sorted", |axis| {
        let mut boxes = sorted(axis);
        for pair in boxes.chunks_exact_mut(2).step_by(5) {
            pair.swap(0, 1);
        }
        boxes
    }));
    family
}

/// Boxes with integer corners and sides of 0, 1 or 2, so that most bounds are equal to others.
pub(crate) fn ties<R: Number, const D: usize>() -> Family<R, D> {
    each(
        [(200, 3), (600, 10), (600, 30), (600, 200)],
        |(n, extent)| format!("{n} boxes with corners of {extent} numbers per axis"),
        |(n, extent)| {
            list(29, n, |random, _| {
                let mins = from_fn(|_| random.whole(0, extent - 1));
                (mins, from_fn(|_| random.whole(0, 2)))
            })
        },
    )
}
