//! Every kind of input against the oracle.

use super::*;
use crate::endpoints::MAX_BOXES;
use crate::{BruteForce, InvalidInputReason};

/// Finds the pairs of `boxes` with a kernel whose scratch memory may be used already, and compares them with the
/// oracle's.
fn check<R: Real, const D: usize>(kernel: &mut RankSweep<R, D>, boxes: &[Aabb<R, D>], what: &str) {
    let (mut found, mut expected) = (vec![[7, 7]], Vec::new());
    kernel.find_pairs(boxes, &mut found).unwrap();
    BruteForce.find_pairs(boxes, &mut expected).unwrap();
    assert!(found.iter().all(|[a, b]| a < b), "{what}");
    found.sort();
    // Each pair once: the oracle has no doubles.
    assert!(found == expected, "{what}: n = {}, D = {D}", boxes.len());
}

/// A recipe for the low and the high side of a box, by random numbers.
type Interval = fn(&mut oorandom::Rand64) -> [f64; 2];

fn pick(random: &mut oorandom::Rand64, from: &[f64]) -> f64 {
    from[random.rand_range(0..from.len() as u64) as usize]
}

const fn point(x: f64) -> [f64; 2] {
    [x, x]
}

/// An interval between two of the given numbers.
fn between(random: &mut oorandom::Rand64, from: &[f64]) -> [f64; 2] {
    let (a, b) = (pick(random, from), pick(random, from));
    [a.min(b), a.max(b)]
}

const INTERVALS: &[(&str, Interval)] = &[
    ("one size", |random| {
        let low = random.rand_float() * 30.0;
        [low, low + 1.0]
    }),
    ("about one size", |random| {
        let low = random.rand_float() * 30.0;
        [low, low + 1.0 + 0.2 * random.rand_float()]
    }),
    ("many sizes", |random| {
        let low = random.rand_float() * 30.0 - 15.0;
        [low, low + random.rand_float().powi(8) * 20.0]
    }),
    ("clusters", |random| {
        let centre = random.rand_range(0..4) as f64 * 100.0;
        let low = centre + random.rand_float() * random.rand_float() * 4.0;
        [low, low + 1.0]
    }),
    ("coincident", |_| [3.0, 4.0]),
    ("touching", |random| {
        let low = random.rand_range(0..12) as f64;
        [low, low + 1.0]
    }),
    ("touching or a little apart", |random| {
        let low = random.rand_range(0..12) as f64;
        [low, low + pick(random, &[1.0, 1.0 - 1e-6])]
    }),
    ("points", |random| point(random.rand_range(0..10) as f64)),
    ("line", |random| {
        let other = random.rand_float();
        let low = pick(random, &[0.0, 0.0, 0.0, other]);
        [low, low + 0.5]
    }),
    ("one huge", |random| {
        let low = random.rand_float() * 30.0;
        let size = if random.rand_range(0..40) == 0 {
            1e4
        } else {
            0.7
        };
        [low - size / 3.0, low + size]
    }),
    ("infinite", |random| {
        let (inf, low) = (f64::INFINITY, random.rand_range(0..9) as f64);
        match random.rand_range(0..12) {
            0 => [-inf, inf],
            1 => [-inf, low],
            2 => [low, inf],
            3 => point(pick(random, &[-inf, inf])),
            _ => [low, low + random.rand_float()],
        }
    }),
    ("finite to the last", |random| {
        between(random, &[f64::MIN, -1e30, -1.0, 1e30, 1.5e30, f64::MAX])
    }),
    ("huge coordinates", |random| {
        let low = (random.rand_float() - 0.5) * 1e30;
        [low, low + 1e28 * random.rand_float()]
    }),
    ("sizes round away", |random| {
        let low = 1e7 + random.rand_range(0..20) as f64;
        [low, low + 0.75]
    }),
    ("sizes round away, many", |random| {
        let low = 3.0e7 + random.rand_float() * 60.0;
        [low, low + pick(random, &[0.5, 3.0, 7.0])]
    }),
    ("signed zeros", |random| {
        let [low, high] = between(random, &[-1.0, 0.0, 0.0, 1.0]);
        let sign = |x: f64, minus: bool| if x == 0.0 && minus { -0.0 } else { x };
        let minus = random.rand_range(0..4);
        [sign(low, minus & 1 == 0), sign(high, minus & 2 == 0)]
    }),
    ("denormal", |random| {
        between(random, &[-5e-324, -1e-45, 0.0, 5e-324, 1e-45, 3e-45, 1e-40])
    }),
];

/// `n` boxes, each side by a recipe of its axis.
fn scene<R: Real, const D: usize>(n: usize, recipes: [Interval; D], seed: u64) -> Vec<Aabb<R, D>> {
    let mut random = oorandom::Rand64::new(seed.into());
    let mut boxes = Vec::with_capacity(n);
    for _ in 0..n {
        let sides = recipes.map(|recipe| recipe(&mut random).map(R::from_f64));
        boxes.push(Aabb::new(sides.map(|s| s[0]), sides.map(|s| s[1])));
    }
    boxes
}

/// Every recipe on all axes, then mixtures of them, in all sizes.
fn check_scenes<R: Real, const D: usize>() {
    let mut kernel = RankSweep::default();
    for (seed, (what, recipe)) in (0..).zip(INTERVALS) {
        for n in (0..=130).chain([2047 + seed as usize % 3]) {
            check::<R, D>(&mut kernel, &scene(n, [*recipe; D], seed), what);
        }
    }
    let mut random = oorandom::Rand64::new(D as u128);
    for seed in 0..1000 {
        let mut recipe = || INTERVALS[random.rand_range(0..INTERVALS.len() as u64) as usize].1;
        let recipes = core::array::from_fn(|_| recipe());
        let n = random.rand_range(0..200) as usize;
        check::<R, D>(
            &mut kernel,
            &scene(n, recipes, seed),
            &format!("mixture {seed}"),
        );
    }
}

#[test]
fn scenes_f32_1d() {
    check_scenes::<f32, 1>();
}

#[test]
fn scenes_f32_2d() {
    check_scenes::<f32, 2>();
}

#[test]
fn scenes_f32_3d() {
    check_scenes::<f32, 3>();
}

#[test]
fn scenes_f64_2d() {
    check_scenes::<f64, 2>();
}

#[test]
fn scenes_f64_3d() {
    check_scenes::<f64, 3>();
}

#[test]
fn scenes_f64_4d() {
    check_scenes::<f64, 4>();
}

#[test]
fn a_grid_of_touching_boxes() {
    let cell = |i: u32| [i % 45, i / 45].map(|x| x as f32);
    let boxes = (0..45 * 45).map(cell);
    let boxes: Vec<_> = boxes.map(|x| Aabb::new(x, x.map(|x| x + 1.0))).collect();
    check(&mut RankSweep::default(), &boxes, "grid");
    let mut pairs = Vec::new();
    RankSweep::default().find_pairs(&boxes, &mut pairs).unwrap();
    assert_eq!(pairs.len(), 2 * 44 * 45 + 2 * 44 * 44);
}

/// Where coordinates are large, `x + 1` rounds different `x` to one number; the object ids are against the order of `x`.
#[test]
fn ends_that_rounding_made_equal() {
    let low = (0..64).map(|i| 16_777_216.0_f32 - 32.0 + (63 - i) as f32);
    let boxes: Vec<_> = low.map(|x| Aabb::new([x, x], [x + 1.0, x + 1.0])).collect();
    assert!(boxes.windows(2).any(|w| w[0].maxs == w[1].maxs));
    check(&mut RankSweep::default(), &boxes, "rounded ends");
}

#[test]
fn boxes_of_one_size_are_not_tested() {
    // The sum is monotone, however it rounds: no box ends before one that begins earlier.
    let recipe: Interval = |random| point(random.rand_float() * 1e5 - 5e4);
    let mut boxes = scene::<f32, 2>(5000, [recipe; 2], 1);
    for b in &mut boxes {
        b.maxs = b.mins.map(|x| x + 9.1);
    }
    let mut kernel = RankSweep::default();
    check(&mut kernel, &boxes, "one size");
    let Sweep {
        orders: [order, _],
        ranks,
        lows,
        ..
    } = &mut kernel.sweep;
    let [first, _] = &mut kernel.narrow;
    first.sort(&boxes, 0, order);
    assert!(ranks::rank_endpoints(&first.keys, order, lows, ranks));
}

#[cfg(feature = "parallel")]
#[test]
fn both_axes_at_once_are_as_one_after_the_other() {
    let recipe: Interval = |random| point(random.rand_float() * 300.0);
    let mut boxes = scene::<f32, 2>(SORT_BOTH_AXES_FROM + 1, [recipe; 2], 1);
    for b in &mut boxes {
        b.maxs = b.mins.map(|x| x + 1.0);
    }
    let [(one, few), (two, many)] = [1, 2].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let mut kernel = RankSweep::default();
        let mut pairs = Vec::new();
        let found = pool
            .build()
            .unwrap()
            .install(|| kernel.find_pairs(&boxes, &mut pairs));
        assert_eq!(found, Ok(()));
        (kernel, pairs)
    });
    assert!(few.len() > 1000);
    assert!(few == many, "another answer, or another order");
    assert!(one.sweep.orders[1].is_empty());
    assert!(!two.sweep.orders[1].is_empty());
    check(&mut RankSweep::default(), &boxes[..3000], "some of them");
}

#[test]
fn times_are_taken_on_demand() {
    let recipe: Interval = |random| point(random.rand_float() * 300.0);
    let boxes = scene::<f32, 2>(1000, [recipe; 2], 1);
    let mut kernel = RankSweep::default();
    check(&mut kernel, &boxes, "not timed");
    assert_eq!(kernel.phase_times(), PhaseTimes::default());
    let mut kernel = kernel.timed();
    check(&mut kernel, &boxes, "timed");
    let times = kernel.phase_times();
    assert!(
        [times.read, times.sort, times.sweep]
            .iter()
            .all(|time| !time.is_zero())
    );
}

#[test]
fn invalid_inputes_are_named_and_leave_no_pairs() {
    let mut boxes = vec![Aabb::new([0.0_f32, 0.0], [1.0, 1.0]); 3];
    let mut kernel = RankSweep::default();
    let mut pairs = Vec::new();
    for (mins, reason) in [
        ([0.0, f32::NAN], InvalidInputReason::NotANumber { axis: 1 }),
        ([2.0, 0.0], InvalidInputReason::Inverted { axis: 0 }),
    ] {
        pairs.push([0, 1]);
        boxes[1].mins = mins;
        let error = kernel.find_pairs(&boxes, &mut pairs).unwrap_err();
        assert_eq!((error.index, error.reason), (1, reason));
        assert!(pairs.is_empty());
    }
    check(&mut kernel, &boxes[2..], "after errors");
    assert_eq!(check_count(MAX_BOXES), Ok(()));
    let error = check_count(MAX_BOXES + 1).unwrap_err();
    assert_eq!(
        (error.index, error.reason),
        (MAX_BOXES, InvalidInputReason::TooMany)
    );
}
