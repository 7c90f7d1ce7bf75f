//! Tests of internals, which the suite over all kernels does not see.

use super::*;
use crate::brute_force::BruteForce;
use oorandom::Rand32;
use worker::Worker;

/// Boxes of two sizes, specks that crowd in one tube of the large ones, and rods that pass between them.
#[cfg(feature = "_adapter")]
fn boxes_rods_and_a_crowd() -> Vec<Aabb<f32, 3>> {
    let mut random = Rand32::new(9);
    let mut at = |least: [f32; 3], spread: [f32; 3], sides: [f32; 3]| {
        let mins = core::array::from_fn(|k| least[k] + spread[k] * random.rand_float());
        Aabb::new(mins, core::array::from_fn(|k| mins[k] + sides[k]))
    };
    // So few specks that no class is made for them.
    let mut boxes: Vec<_> = (0..6000)
        .map(|_| at([0.0; 3], [60.0; 3], [3.0; 3]))
        .collect();
    boxes.extend((0..100).map(|_| at([0.0; 3], [60.0; 3], [30.0; 3])));
    boxes.extend((0..400).map(|_| at([35.0, 100.0, 100.0], [0.02, 2.0, 2.0], [0.01; 3])));
    boxes.extend((0..50).map(|_| at([35.0, 80.0, 100.0], [0.02, 0.0, 2.0], [1e-3, 40.0, 1e-3])));
    boxes
}

#[cfg(feature = "_adapter")]
#[test]
fn queries_within_their_budget_have_all_their_pairs() {
    let boxes = boxes_rods_and_a_crowd();
    let members: Vec<_> = (0..boxes.len() as u32).collect();
    let mut kernel = GridSweep::<f32, 3>::default();
    let none = None::<fn([u32; 2]) -> bool>;
    kernel.find_among(&boxes, members.clone(), true, none, usize::MAX, &mut vec![]);
    assert!(kernel.classes.len() > 1);
    let mut given_up = Vec::new();
    for budget in (0..20).map(|i| 100 * i).chain([u64::MAX]) {
        let mut found = Vec::new();
        let mut search = Search::new(&boxes, None, usize::MAX, &mut found);
        let look_up = |i, worker: &mut Worker| {
            let classes = kernel.classes.iter();
            classes.for_each(|class| class.look_up(&boxes, i, worker));
        };
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
    assert!(given_up[0].min(given_up[2]) > 0 && given_up[20] == 0);
}

#[cfg(feature = "_adapter")]
#[test]
fn any_number_of_slabs_gives_up_if_there_are_too_many_pairs() {
    let boxes = boxes_rods_and_a_crowd();
    let mut all = Vec::new();
    BruteForce.find_pairs(&boxes, &mut all).unwrap();
    let members: Vec<_> = (0..boxes.len() as u32).collect();
    let wanted = |[a, b]: [u32; 2]| (a + b) % 3 == 0;
    let count = all.len();
    for slabs in [1, 2, 3, 8, 16] {
        let mut kernel = GridSweep::<f32, 3>::with_slabs(slabs.try_into().unwrap());
        for most in [0, 1, count / 8, count / 2, count - 1, count, usize::MAX] {
            let mut found = Vec::new();
            let (list, want) = (members.clone(), Some(wanted));
            let overlapping = kernel.find_among(&boxes, list, true, want, most, &mut found);
            assert_eq!(overlapping > most, count > most);
            assert!(found.len() <= slabs.saturating_mul(most));
            found.sort_unstable();
            assert!(found.iter().all(|pair| all.binary_search(pair).is_ok()));
            let wanted = all.iter().copied().filter(|&pair| wanted(pair));
            assert!(overlapping > most || overlapping == count && wanted.eq(found));
        }
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
        let mut worker = Worker::new(&mut found, usize::MAX);
        segment_tree::match_all(&mut entries, &mut worker);
        assert_eq!(worker.finish().emitted, all.len());
        found.sort_unstable();
        assert!(found == all);
        // Between two lists, by any number of threads.
        let (left, right): (Vec<u32>, Vec<u32>) = (0..boxes.len() as u32).partition(|i| i % 5 < 2);
        all.retain(|pair| (pair[0] % 5 < 2) != (pair[1] % 5 < 2));
        for threads in [1, 8] {
            for most in [usize::MAX, all.len() / 2, 0] {
                let mut found = vec![[7; 2]];
                parallel::with_threads(threads, || {
                    let mut search = Search::new(&boxes, None, most, &mut found);
                    search.match_lists(&left, &right);
                    assert_eq!(search.is_over(), all.len() > most);
                });
                assert!(found[0] == [7; 2] && (found[1..] == all || all.len() > most));
            }
        }
    }
    for seed in 0..60 {
        check::<1>(seed);
        check::<2>(seed);
        check::<3>(seed);
    }
}
