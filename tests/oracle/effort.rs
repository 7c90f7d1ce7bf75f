//! The effort of `GridSweep` grows with boxes and pairs. It is counted in comparisons, so the tests need no clock.

use crate::arrangements::{Aimed, HardBoxes, Mixture, Needles};
use crate::random::Random;
use unisize::{Aabb, BruteForce, GridSweep, PairFinder, Real};

/// The limit of comparisons and visited tubes per box and pair.
const BOUND: f64 = 400.0;

/// The limit of growth per box and pair with four times as many boxes, above a number of comparisons: more tubes may be crowded, and a
/// segment tree has more levels.
const GROWTH: f64 = 3.0;

/// The boxes with the axes rotated `turns` times.
fn turned<R: Real, const D: usize>(boxes: &[[[f32; D]; 2]], turns: usize) -> Vec<Aabb<R, D>> {
    let number = |x: f32| R::from_f64(x.into());
    let turned = |corner: &[f32; D]| std::array::from_fn(|k| number(corner[(k + turns) % D]));
    let boxes = boxes.iter();
    boxes
        .map(|[mins, maxs]| Aabb::new(turned(mins), turned(maxs)))
        .collect()
}

/// Comparisons per box and pair.
fn effort<R: Real, const D: usize>(boxes: &[Aabb<R, D>]) -> f64 {
    let (mut kernel, mut pairs) = (GridSweep::default(), Vec::new());
    assert_eq!(kernel.find_pairs(boxes, &mut pairs), Ok(()));
    kernel.compared() as f64 / (boxes.len() + pairs.len()) as f64
}

/// Fails unless the pairs are those of brute force.
fn assert_pairs<R: Real, const D: usize>(boxes: &[Aabb<R, D>]) {
    let [mut found, mut expected] = [Vec::new(), Vec::new()];
    assert_eq!(GridSweep::default().find_pairs(boxes, &mut found), Ok(()));
    assert_eq!(BruteForce.find_pairs(boxes, &mut expected), Ok(()));
    found.sort_unstable();
    assert!(found == expected);
}

fn check<const D: usize>(name: &str, least: f64, boxes: impl Fn(usize) -> Vec<[[f32; D]; 2]>) {
    check_growth(name, least, [1 << 12, 1 << 14], boxes);
}

fn check_growth<const D: usize>(
    name: &str,
    least: f64,
    counts: [usize; 2],
    boxes: impl Fn(usize) -> Vec<[[f32; D]; 2]>,
) {
    for turns in 0..D {
        let [few, many] = counts.map(|count| effort(&turned::<f32, D>(&boxes(count), turns)));
        assert!(
            many < BOUND && many < GROWTH * few.max(least),
            "{name} in {D}D, turned {turns} times: {few}, {many}"
        );
    }
}

#[test]
fn effort_grows_with_boxes_and_pairs() {
    for kind in HardBoxes::ALL {
        // Coincident boxes have a quadratic number of pairs.
        if kind != HardBoxes::Coincident {
            check::<2>(kind.name(), 16.0, |count| kind.boxes(count, 7));
            check::<3>(kind.name(), 16.0, |count| kind.boxes(count, 7));
        }
    }
}

/// Boxes that a grid once took all for one tube.
#[test]
fn effort_grows_linearly_where_boxes_have_odd_sizes() {
    let infinity = f32::INFINITY;
    let square = |i: usize, side: usize| [(i % side) as f32, (i / side) as f32];
    let side = |count: usize| (count as f64).sqrt() as usize;
    for depth in [[-infinity, infinity], [0.0, infinity], [-1e32, 1e32]] {
        check::<3>("plane of infinite rods", 16.0, |count| {
            let corner = |i| square(i, side(count)).map(|x| 1.5 * x);
            let rod = |[x, y]: [f32; 2]| [[x, y, depth[0]], [x + 1.0, y + 1.0, depth[1]]];
            (0..count).map(|i| rod(corner(i))).collect()
        });
        check::<3>("rods in a stack, and cubes", 32.0, |count| {
            let rod = |z| [[0.0, depth[0], z], [1.0, depth[1], z + 0.5]];
            let cube = |z| [[3.0, 0.0, z], [4.0, 1.0, z + 0.5]];
            let one = |i: usize| match i % 5 {
                0 => rod(i as f32),
                _ => cube(i as f32),
            };
            (0..count).map(one).collect()
        });
    }
    check::<2>("points most of which have one coordinate", 16.0, |count| {
        let point = |i: usize| match (i % 5, i as f32 / count as f32) {
            (3, t) => [0.5, 0.0001 + 0.001 * t],
            (4, t) => [0.5, -0.0001 - 0.001 * t],
            _ => [i as f32, 0.0],
        };
        (0..count).map(|i| [point(i); 2]).collect()
    });
}

/// Where few boxes crowd among many, the effort needs many boxes to grow.
#[test]
fn effort_grows_linearly_where_few_boxes_crowd_in_a_row() {
    for one_in in [9, 12, 20, 31] {
        // A tube may take more than a hundred comparisons per box before it counts as crowded.
        check_growth::<2>(
            "specks in a row",
            BOUND / 4.0,
            [1 << 16, 1 << 18],
            |count| {
                let one = |i: usize| match (i % one_in, i as f32) {
                    (0, x) => {
                        let y = 3.0 + x / count as f32;
                        [[0.5, y], [0.8, y + 1e-6]]
                    }
                    (_, x) => [[2.0 * x, 0.0], [2.0 * x + 1.0, 1.0]],
                };
                (0..count).map(one).collect()
            },
        );
    }
}

#[test]
fn effort_grows_linearly_for_the_worst_known_mixtures() {
    for (i, mixture) in Mixture::WORST.iter().enumerate() {
        let name = format!("mixture {}", i + 1);
        // The best way to search a mixture may be another one with more boxes.
        check::<2>(&name, BOUND / 4.0, |count| mixture.boxes(count, 7));
        check::<3>(&name, BOUND / 4.0, |count| mixture.boxes(count, 7));
    }
}

/// Look-ups between needles of several directions, each of which reaches many tubes, once took thousands of comparisons.
#[test]
fn effort_is_bounded_for_needles_that_pass_each_other() {
    let random = (0..40).map(|seed| Needles::random(seed).varied(seed));
    for (i, needles) in Needles::WORST.into_iter().chain(random).enumerate() {
        for turns in 0..3 {
            let boxes = needles.boxes::<3>(1 << 14, 7);
            let single = effort(&turned::<f32, 3>(&boxes, turns));
            let double = effort(&turned::<f64, 3>(&boxes, turns));
            assert!(
                single.max(double) < 1000.0,
                "needles {i}, turned {turns} times: {single}, {double}"
            );
        }
    }
}

/// Each sample of what was left once saw a single size, so that there was a class for each size.
#[test]
fn no_order_of_boxes_takes_much_more_effort_than_another() {
    fn check<R: Real, const D: usize>(most: f64) {
        let real = |corner: [f64; D]| corner.map(R::from_f64);
        let boxes = Aimed::RODS.boxes(1 << 14, most);
        let mut boxes: Vec<_> = boxes
            .into_iter()
            .map(|[mins, maxs]| Aabb::new(real(mins), real(maxs)))
            .collect();
        let aimed = effort(&boxes);
        assert_pairs(&boxes);
        Random::new(7).shuffle(&mut boxes);
        let shuffled = effort(&boxes);
        assert!(aimed < 3.0 * shuffled, "{D}D: {aimed}, {shuffled}");
    }
    check::<f32, 2>(1e30);
    check::<f32, 3>(1e30);
    check::<f64, 2>(1e300);
    check::<f64, 3>(1e300);
}

/// A wall once visited a row of boxes again for each of thousands of strips that share the number of the row's tube.
#[test]
fn effort_is_bounded_where_walls_reach_tubes_that_share_numbers() {
    for walls in [1, 20] {
        let count = 16_448;
        let cube = |corner: [f64; 3]| Aabb::new(corner, corner.map(|x| x + 1.0));
        // So far apart that the grid has a power of two of strips along the last axis.
        let place = |i: usize| 6.663_818_359_375 * (i as f64 / 2.0 - count as f64 / 4.0);
        let one = |i: usize| match i % 2 {
            0 => cube([2.0 * i as f64, 0.0, place(i)]),
            _ => cube([2.0 * i as f64, 0.0, 0.0]),
        };
        let mut boxes: Vec<_> = (0..count - 1 - walls).map(one).collect();
        boxes.push(cube([5.0, 43_416.0, 0.0]));
        let end = 2.0 * count as f64 + 10.0;
        let wall = Aabb::new([-10.0, 20.0, 0.25], [end, 43_418.0, 0.5]);
        boxes.extend(std::iter::repeat_n(wall, walls));
        let effort = effort(&boxes);
        assert!(effort < BOUND, "{walls} walls: {effort}");
        assert_pairs(&boxes);
    }
}

/// Lists of a few hundred boxes seldom need a segment tree.
#[test]
fn many_needles_have_the_pairs_of_brute_force() {
    for needles in Needles::WORST {
        for turns in 0..3 {
            assert_pairs(&turned::<f32, 3>(&needles.boxes::<3>(1 << 14, 7), turns));
        }
    }
}
