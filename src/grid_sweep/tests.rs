//! Tests of internals, which the suite over all kernels does not see.

use super::*;
use crate::brute_force::BruteForce;
use crate::tuning::kernel::GRID_SAMPLE;
#[cfg(feature = "_adapter")]
use oorandom::Rand32;

/// Compares the pairs that a kernel finds with those that brute force finds.
fn check<R: Real, const D: usize>(kernel: &mut GridSweep<R, D>, boxes: &[Aabb<R, D>]) {
    let [mut found, mut expected] = [Vec::new(), Vec::new()];
    kernel.find_pairs(boxes, &mut found).unwrap();
    BruteForce.find_pairs(boxes, &mut expected).unwrap();
    found.sort_unstable();
    assert!(found == expected);
}

fn cube<const D: usize>(mins: [f32; D]) -> Aabb<f32, D> {
    Aabb::new(mins, mins.map(|x| x + 1.0))
}

/// All boxes of the sample are points, and most others are too large for a grid that suits the sample.
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
        check(&mut GridSweep::default(), &boxes);
    }
}

/// The product of the sample's size and the number of boxes does not fit in 32 bits.
#[test]
fn millions_are_sampled() {
    const COUNT: usize = 1 << 21;
    const ROW: usize = 1 << 11;
    fn count_pairs<const D: usize>(place: fn(usize) -> [f32; D]) -> usize {
        let boxes: Vec<_> = (0..COUNT).map(|i| cube(place(i))).collect();
        let mut pairs = Vec::new();
        GridSweep::default().find_pairs(&boxes, &mut pairs).unwrap();
        pairs.len()
    }
    fn row(i: usize) -> [f32; 2] {
        [0.75 * (i % ROW) as f32, 4.0 * (i / ROW) as f32]
    }
    let flat = |i| [row(i)[0], row(i)[1], 0.0];
    assert_eq!(count_pairs(|i| [0.75 * i as f32; 2]), COUNT - 1);
    assert_eq!(count_pairs(|i| [0.75 * i as f32; 3]), COUNT - 1);
    assert_eq!(count_pairs(row), COUNT - COUNT / ROW);
    assert_eq!(count_pairs(flat), COUNT - COUNT / ROW);
}

/// One box is so far away that plates across all of space reach 2⁶¹ tubes.
#[test]
fn plates_reach_very_many_tubes() {
    let at = |mins: [f64; 3]| Aabb::new(mins, mins.map(|x| x + 1.0));
    let near = (0..1000).map(|i| at([0.0, (i % 32) as f64 / 2.0, (i / 32) as f64 / 2.0]));
    let plate = |k: u32| {
        let x = f64::from(k) / 100.0;
        let [mins, maxs] = [[x, -f64::INFINITY], [x + 0.005, f64::INFINITY]];
        Aabb::new([mins[0], mins[1], mins[1]], [maxs[0], maxs[1], maxs[1]])
    };
    let boxes = near.chain([at([0.0, 3e9, 3e9])]);
    let boxes: Vec<_> = boxes.chain((0..100).map(plate)).collect();
    check(&mut GridSweep::default(), &boxes);
}

/// Boxes that crowd in one tube, among others that are far apart.
#[cfg(feature = "_adapter")]
#[test]
fn a_crowd_has_a_grid_of_its_own() {
    let mut random = Rand32::new(5);
    let distant = (0..2000).map(|i| 40.0 * i as f32);
    let mut boxes: Vec<_> = distant
        .map(|x| Aabb::new([x, 0.0, 0.0], [x + 20.0, 20.0, 20.0]))
        .collect();
    let mut speck = || cube([6.0, 60.0, 60.0].map(|x| 1e3 + x * random.rand_float()));
    boxes.extend((0..2000).map(|_| speck()));
    let mut kernel = GridSweep::default();
    check(&mut kernel, &boxes);
    let crowds = |kernel: &GridSweep<f32, 3>| -> usize {
        let classes = kernel.classes[..kernel.class_count].iter();
        let slabs = classes.flat_map(|class| &class.slabs);
        let tubes = slabs.flat_map(|slab| &slab.tubes);
        tubes.filter(|tube| tube.crowd.is_some()).count()
    };
    // Tubes are not kept unless boxes will be looked up.
    assert_eq!(crowds(&kernel), 0);
    let members: Vec<_> = (0..boxes.len() as u32).collect();
    let [mut found, mut expected] = [Vec::new(), Vec::new()];
    let stopwatch = &mut Stopwatch::default();
    let all = None::<fn([u32; 2]) -> bool>;
    kernel.find_among(&boxes, &members, all, usize::MAX, &mut found, stopwatch);
    assert!(crowds(&kernel) > 0);
    kernel.prepare_lookup();
    found.clear();
    let queries: Vec<_> = (0..boxes.len() as u32).step_by(7).collect();
    kernel.look_up(&boxes, &queries, |_| true, usize::MAX, &mut found);
    for &i in &queries {
        let overlapping = members
            .iter()
            .filter(|&&j| boxes[i as usize].intersects(&boxes[j as usize]));
        expected.extend(overlapping.map(|&j| [i.min(j), i.max(j)]));
    }
    found.sort_unstable();
    expected.sort_unstable();
    assert!(found == expected);
}

/// Boxes of two sizes, and specks that crowd in one tube.
#[cfg(feature = "_adapter")]
#[test]
fn any_number_of_slabs_gives_up_if_there_are_too_many_pairs() {
    let mut random = Rand32::new(9);
    let mut at = |spread: [f32; 3], size: f32| {
        let mins = spread.map(|x| x * random.rand_float());
        Aabb::new(mins, mins.map(|x| x + size))
    };
    let mut boxes: Vec<_> = (0..1000).map(|_| at([40.0; 3], 3.0)).collect();
    boxes.extend((0..100).map(|_| at([40.0; 3], 30.0)));
    boxes.extend((0..1000).map(|_| at([5.0, 2.0, 2.0], 0.01)));
    let mut all = Vec::new();
    BruteForce.find_pairs(&boxes, &mut all).unwrap();
    let members: Vec<_> = (0..boxes.len() as u32).collect();
    let wanted = |[a, b]: [u32; 2]| (a + b) % 3 == 0;
    let stopwatch = &mut Stopwatch::default();
    let count = all.len();
    for slabs in [1, 2, 3, 8, 16] {
        let mut kernel = GridSweep::<f32, 3>::with_slabs(slabs.try_into().unwrap());
        for most in [0, 1, count / 8, count / 2, count - 1, count, usize::MAX] {
            let mut found = Vec::new();
            let overlapping =
                kernel.find_among(&boxes, &members, Some(wanted), most, &mut found, stopwatch);
            assert_eq!(overlapping > most, count > most);
            assert!(found.len() <= slabs.saturating_mul(most));
            found.sort_unstable();
            if overlapping <= most {
                let wanted = all.iter().copied().filter(|&pair| wanted(pair));
                assert!(overlapping == count && wanted.eq(found));
            } else {
                assert!(found.iter().all(|pair| all.binary_search(pair).is_ok()));
            }
        }
        kernel.prepare_lookup();
        let mut found = Vec::new();
        // Each pair by both of its boxes, and each box with itself.
        let both = 2 * count + boxes.len();
        for most in [0, both - 1, both] {
            found.clear();
            let tally = kernel.look_up(&boxes, &members, |_| true, most, &mut found);
            assert_eq!(tally.emitted > most, both > most);
        }
        assert_eq!(found.len(), both);
    }
}
