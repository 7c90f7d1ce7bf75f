//! What the suite over all kernels cannot see: that settings are heeded, and that guesses may be wrong.

use super::*;
use crate::brute_force::BruteForce;
use crate::tuning::kernel::GRID_SAMPLE;
use oorandom::Rand32;

/// The pairs that a kernel finds, which are also checked.
fn checked<const D: usize>(
    kernel: &mut GridSweep<f32, D>,
    boxes: &[Aabb<f32, D>],
) -> Vec<[u32; 2]> {
    let [mut found, mut expected] = [Vec::new(), Vec::new()];
    kernel.find_pairs(boxes, &mut found).unwrap();
    BruteForce.find_pairs(boxes, &mut expected).unwrap();
    let mut sorted = found.clone();
    sorted.sort_unstable();
    assert!(sorted == expected);
    found
}

fn cube<const D: usize>(mins: [f32; D]) -> Aabb<f32, D> {
    Aabb::new(mins, mins.map(|x| x + 1.0))
}

/// Every box that is looked at to choose the grid is flat, and most are too large for any grid so chosen.
#[test]
fn a_sample_that_misleads_costs_time_and_nothing_else() {
    for spread in [0.0, 1e-3, 50.0] {
        let mut boxes: Vec<_> = (0..2000)
            .map(|i| Aabb::new([i as f32, -1e9], [i as f32 + 1.5, 1e9]))
            .collect();
        for i in choose::sample_indices(boxes.len(), GRID_SAMPLE) {
            let corner = [i as f32, spread * (i % 50) as f32];
            boxes[i] = Aabb::new(corner, corner);
        }
        checked(&mut GridSweep::default(), &boxes);
    }
}

/// How many pairs are found among the cubes in so many places.
fn count_pairs<const D: usize>(count: usize, place: fn(usize) -> [f32; D]) -> usize {
    let boxes: Vec<_> = (0..count).map(|i| cube(place(i))).collect();
    let mut pairs = Vec::new();
    GridSweep::default().find_pairs(&boxes, &mut pairs).unwrap();
    pairs.len()
}

/// The product of the sample and of all does not fit in the 32 bits that some processors have.
#[test]
fn millions_are_sampled() {
    const COUNT: usize = 1 << 21;
    const ROW: usize = 1 << 11;
    let found = [
        count_pairs(COUNT, |i| [0.75 * i as f32; 2]),
        count_pairs(COUNT, |i| [0.75 * i as f32; 3]),
    ];
    assert_eq!(found, [COUNT - 1; 2]);
    fn row(i: usize) -> [f32; 2] {
        [0.75 * (i % ROW) as f32, 4.0 * (i / ROW) as f32]
    }
    let found = [
        count_pairs(COUNT, row),
        count_pairs(COUNT, |i| [row(i)[0], row(i)[1], 0.0]),
    ];
    assert_eq!(found, [COUNT - COUNT / ROW; 2]);
}

#[test]
fn one_axis_is_cut_where_boxes_lie_along_a_curve() {
    let along = |step: f32, place: fn(f32) -> [f32; 3]| -> Vec<_> {
        (0..3000).map(|i| cube(place(step * i as f32))).collect()
    };
    for (boxes, are_cut) in [
        (along(0.9, |x| [x, x, x]), [true, false]),
        (along(0.9, |x| [0.0, x, -x]), [true, false]),
        // The first of the two axes goes over the same places again and again.
        (along(30.0, |x| [0.0, x % 3000.0, x * 0.03]), [false, true]),
        // Few boxes share a tube, but many a strip of either axis.
        (
            along(1.0, |x| {
                [0.0, x % 7.0 * 600.0, (x / 7.0).floor() % 7.0 * 600.0]
            }),
            [true, true],
        ),
    ] {
        let mut kernel = GridSweep::default();
        checked(&mut kernel, &boxes);
        let strips = kernel.classes[0].grid.axes.map(|axis| axis.last > 0);
        assert_eq!(strips, are_cut);
    }
}

/// Walls as long as the world, along this axis, with small boxes between them: so many of each.
fn walls<const D: usize>(along: usize, walls: usize, small: usize) -> Vec<Aabb<f32, D>> {
    let mut random = Rand32::new(along as u64);
    let side = (5.0 * small as f32).powf(1.0 / D as f32);
    let mut place =
        || -> [f32; D] { core::array::from_fn(|_| (side * random.rand_float()).floor()) };
    let small = (0..small).map(|_| cube(place().map(|x| x + 0.25)));
    let mut boxes: Vec<_> = small.collect();
    boxes.extend((0..walls).map(|_| {
        let mut mins = place();
        mins[along] = 0.0;
        let mut maxs = mins.map(|x| x + 0.5);
        maxs[along] = side;
        Aabb::new(mins, maxs)
    }));
    boxes
}

/// Many walls do not visit all tubes that they span, and a few do not have all others look for them.
#[test]
fn the_fewer_look_ups_are_made() {
    fn seekers<const D: usize>(along: usize, count: usize) -> usize {
        let mut kernel = GridSweep::default();
        checked::<D>(&mut kernel, &walls(along, count, 3000));
        let classes = &kernel.classes[..kernel.class_count];
        classes.iter().map(|class| class.seekers.len()).sum()
    }
    assert!(seekers::<2>(1, 500) >= 3000);
    for along in 0..3 {
        assert_eq!(seekers::<3>(along, 5), 0);
        assert_eq!(seekers::<2>(along % 2, 5), 0);
    }
}
