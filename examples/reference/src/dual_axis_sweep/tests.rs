//! What the oracle does not see: that only overlapping intervals are looked at.

use super::*;
use oorandom::Rand32;

/// Ranks of intervals at random places, with lengths of several orders of magnitude.
fn random_ranks(n: usize, random: &mut Rand32) -> Vec<[u32; 2]> {
    let mut ends: Vec<(f32, usize)> = Vec::new();
    for i in 0..n {
        let low = random.rand_float() * 100.0;
        let size = [0.0, 0.1, 1.0, 1.1, 20.0, 1e3][random.rand_range(0..6) as usize];
        ends.extend([(low, i), (low + size, i)]);
    }
    ends.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut ranks = vec![[0; 2]; n];
    for (rank, (_, i)) in (1..).zip(ends) {
        let side = usize::from(ranks[i][0] != 0);
        ranks[i][side] = rank;
    }
    ranks
}

#[test]
fn a_class_finds_all_that_overlap_and_looks_at_few_twice() {
    let mut random = Rand32::new(1);
    for _ in 0..300 {
        let ranks = random_ranks(random.rand_range(1..80) as usize, &mut random);
        let greatest = 2 * ranks.len() as u32;
        for number in 0..CLASSES {
            let in_class = |r: &[u32; 2]| class_of(r[1] - r[0]) == number;
            let all: Vec<[u32; 2]> = ranks.iter().copied().filter(in_class).collect();
            if all.is_empty() {
                continue;
            }
            let mut class = LengthClass::default();
            class.clear();
            all.iter().for_each(|r| class.admit(r[1] - r[0]));
            class.reset(greatest);
            // Some of those that may be inserted are not.
            let active: Vec<_> = all.iter().filter(|_| random.rand_range(0..4) > 0).collect();
            for (i, &&r) in active.iter().enumerate() {
                assert_eq!(class.insert(r), i == 0);
            }
            for &asked in ranks.iter().filter(|r| !active.contains(r)) {
                check_class(&class, &active, asked);
            }
            for (left, &&r) in (0..active.len()).rev().zip(&active) {
                assert_eq!(class.remove(r), left == 0);
            }
        }
    }
}

/// Checks what a class answers for one interval.
fn check_class(class: &LengthClass, active: &[&[u32; 2]], asked: [u32; 2]) {
    let (mut beginning, mut ending) = (Vec::new(), Vec::new());
    class.beginning(asked, |rank| beginning.push(rank));
    class.ending(asked[0], |rank| ending.push(rank));
    let overlapping = |r: &&&[u32; 2]| r[0] < asked[1] && asked[0] < r[1];
    let expected: Vec<_> = active.iter().filter(overlapping).collect();

    // Everything that is looked at overlaps.
    let by_low = beginning
        .iter()
        .map(|low| expected.iter().position(|r| r[0] == *low));
    let by_high = ending
        .iter()
        .map(|high| expected.iter().position(|r| r[1] == *high));
    let mut found: Vec<_> = by_low.collect();
    let all_ending: Vec<_> = by_high.collect();
    assert!(
        found.iter().chain(&all_ending).all(Option::is_some),
        "{asked:?} among {active:?}"
    );

    // And every overlapping interval is found once.
    let earliest = class.earliest(asked[0]);
    found.extend(
        all_ending
            .into_iter()
            .filter(|at| expected[at.unwrap()][0] <= earliest),
    );
    found.sort();
    assert!(
        found.into_iter().eq((0..expected.len()).map(Some)),
        "{asked:?} among {active:?}"
    );
}

#[test]
fn boxes_of_one_size_are_of_few_classes() {
    let mut random = Rand32::new(1);
    let mut corner = || [random.rand_float() * 100.0, random.rand_float() * 100.0];
    let lows: Vec<[f32; 2]> = (0..5000).map(|_| corner()).collect();
    let mut boxes: Vec<_> = lows
        .iter()
        .map(|x| Aabb::new(*x, x.map(|x| x + 1.0)))
        .collect();
    // A box that contains all others on the first axis has a class of its own, so it widens no range.
    boxes.push(Aabb::new([-1.0, 200.0], [200.0, 201.0]));
    let mut kernel = DualAxisSweep::default();
    let (mut pairs, mut expected) = (Vec::new(), Vec::new());
    kernel.find_pairs(&boxes, &mut pairs).unwrap();
    unisize::BruteForce
        .find_pairs(&boxes, &mut expected)
        .unwrap();
    pairs.sort();
    assert_eq!(pairs, expected);

    let lengths = kernel.sweep.ranks.iter().map(|r| class_of(r[1] - r[0]));
    let mut classes: Vec<_> = lengths.collect();
    classes.sort();
    classes.dedup();
    assert!(classes.len() <= 4, "{classes:?}");
    assert_eq!(classes.last(), Some(&class_of(2 * 5000 + 1)));
}
