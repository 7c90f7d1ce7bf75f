//! Tests of internals, which the suite over all kernels does not see.

use super::*;
use crate::brute_force::BruteForce;
use crate::tuning::kernel::GRID_SAMPLE;
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
    kernel.look_up_queries(&boxes, &queries, |_| true, usize::MAX, &mut found);
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

/// Boxes of two sizes, specks that crowd in one tube, and rods that pass between them.
#[cfg(feature = "_adapter")]
fn boxes_rods_and_a_crowd() -> Vec<Aabb<f32, 3>> {
    let mut random = Rand32::new(9);
    let mut at = |least: [f32; 3], spread: [f32; 3], sides: [f32; 3]| {
        let mins = core::array::from_fn(|k| least[k] + spread[k] * random.rand_float());
        Aabb::new(mins, core::array::from_fn(|k| mins[k] + sides[k]))
    };
    let mut boxes: Vec<_> = (0..1000)
        .map(|_| at([0.0; 3], [40.0; 3], [3.0; 3]))
        .collect();
    boxes.extend((0..100).map(|_| at([0.0; 3], [40.0; 3], [30.0; 3])));
    let (corner, spread) = ([35.0, 38.0, 38.0], [0.02, 2.0, 2.0]);
    boxes.extend((0..1000).map(|_| at(corner, spread, [0.01; 3])));
    boxes.extend((0..50).map(|_| at([35.0, 0.0, 38.0], [0.02, 0.0, 2.0], [1e-3, 40.0, 1e-3])));
    boxes
}

#[cfg(feature = "_adapter")]
#[test]
fn queries_within_their_budget_have_all_their_pairs() {
    let boxes = boxes_rods_and_a_crowd();
    let members: Vec<_> = (0..boxes.len() as u32).collect();
    let stopwatch = &mut Stopwatch::default();
    let mut kernel = GridSweep::<f32, 3>::default();
    let none = None::<fn([u32; 2]) -> bool>;
    kernel.find_among(&boxes, &members, none, usize::MAX, &mut vec![], stopwatch);
    kernel.prepare_lookup();
    let mut given_up = Vec::new();
    for budget in (0..100).map(|i| 20 * i).chain([usize::MAX]) {
        let mut found = Vec::new();
        let mut search = Search::new(&boxes, &mut found, stopwatch);
        let look_up = |i, emitter: &mut Emitter| kernel.look_up_box(&boxes[i as usize], i, emitter);
        let costly = search.run_queries(&members, budget, look_up);
        let mut expected = Vec::new();
        for &i in members.iter().filter(|i| costly.binary_search(i).is_err()) {
            let overlaps = |&j: &u32| boxes[i as usize].intersects(&boxes[j as usize]);
            let others = members.iter().copied().filter(overlaps);
            expected.extend(others.map(|j| [i.min(j), i.max(j)]));
        }
        found.sort_unstable();
        expected.sort_unstable();
        assert!(found == expected, "budget {budget}");
        given_up.push(costly.len());
    }
    assert!(
        given_up[0] > 0 && given_up[10] > 0 && given_up[100] == 0,
        "{given_up:?}"
    );
}

#[cfg(feature = "_adapter")]
#[test]
fn any_number_of_slabs_gives_up_if_there_are_too_many_pairs() {
    let boxes = boxes_rods_and_a_crowd();
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
            let tally = kernel.look_up_queries(&boxes, &members, |_| true, most, &mut found);
            assert_eq!(tally.emitted > most, both > most);
        }
        assert_eq!(found.len(), both);
    }
}

/// Boxes of all shapes, many of which begin or end at one coordinate, some without an end.
#[test]
fn a_segment_tree_finds_the_pairs_of_brute_force() {
    fn check<const D: usize>(seed: u64) {
        let mut random = Rand32::new(seed);
        let mut index = |count: usize| random.rand_range(0..count as u32) as usize;
        let steps = [3, 30, 1000][index(3)];
        let boxes: Vec<Aabb<f32, D>> = (0..200 + index(300))
            .map(|_| {
                let mins = core::array::from_fn(|_| match index(20) {
                    0 => f32::NEG_INFINITY,
                    _ => index(steps) as f32,
                });
                let maxs = mins.map(|min| match index(20) {
                    0 => f32::INFINITY,
                    1 => min,
                    2..10 => min + index(steps) as f32,
                    _ => min + index(2) as f32,
                });
                Aabb::new(mins, maxs)
            })
            .collect();
        let mut all = Vec::new();
        BruteForce.find_pairs(&boxes, &mut all).unwrap();
        let entry = |(i, &aabb)| entry::Entry {
            aabb,
            owner: entry::Owner(i),
        };
        let mut entries: Vec<_> = (0..).zip(&boxes).map(entry).collect();
        let mut found = Vec::new();
        let mut emitter = Emitter::new(&mut found, usize::MAX);
        segment_tree::match_all(&mut entries, &mut emitter);
        assert_eq!(emitter.finish().emitted, all.len());
        found.sort_unstable();
        assert!(found == all);
        // Between two lists, by any number of threads.
        let (left, right): (Vec<u32>, Vec<u32>) = (0..boxes.len() as u32).partition(|i| i % 5 < 2);
        all.retain(|pair| (pair[0] % 5 < 2) != (pair[1] % 5 < 2));
        for threads in [1, 8] {
            let (mut found, stopwatch) = (vec![[7; 2]], &mut Stopwatch::default());
            parallel::with_threads(threads, || {
                Search::new(&boxes, &mut found, stopwatch).match_lists(&left, &right);
            });
            assert!(found[0] == [7; 2] && found[1..] == all);
            for most in [0, all.len() / 2] {
                found.clear();
                parallel::with_threads(threads, || {
                    let mut search = Search::new(&boxes, &mut found, stopwatch);
                    search.most = most;
                    search.match_lists(&left, &right);
                    assert_eq!(search.is_over(), all.len() > most);
                });
            }
        }
    }
    for seed in 0..60 {
        check::<1>(seed);
        check::<2>(seed);
        check::<3>(seed);
    }
}
