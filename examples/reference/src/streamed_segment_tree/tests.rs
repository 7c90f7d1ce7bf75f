//! What the suite of all kernels does not see from outside.

use super::*;
use oorandom::Rand32;
use unisize::BruteForce;

/// Boxes with few different sides, so that they coincide and touch, and sides at infinity.
fn boxes(count: usize) -> Vec<Aabb<f32, 3>> {
    let mut random = Rand32::new(5);
    let mut side = || match random.rand_range(0..40) {
        0 => f32::NEG_INFINITY,
        1 => f32::INFINITY,
        i => (i / 2) as f32 - 10.0,
    };
    let mut aabb = || {
        let sides: [[f32; 2]; 3] = core::array::from_fn(|_| [side(), side()]);
        Aabb::new(sides.map(|[a, b]| a.min(b)), sides.map(|[a, b]| a.max(b)))
    };
    (0..count).map(|_| aabb()).collect()
}

fn entries(boxes: &[Aabb<f32, 3>]) -> Vec<Entry<f32, 3>> {
    let entry = |(&aabb, index)| Entry { aabb, index };
    boxes.iter().zip(0..).map(entry).collect()
}

#[test]
fn no_pair_is_lost_where_splits_run_out() {
    let boxes = boxes(300);
    let mut expected = Vec::new();
    BruteForce.find_pairs(&boxes, &mut expected).unwrap();
    for splits in 0..12 {
        let (mut points, mut intervals) = (entries(&boxes), entries(&boxes));
        let mut pairs = Vec::new();
        let mut walk = Walk {
            cutoff: 0,
            median: Median::new(),
            pairs: &mut pairs,
        };
        let everything = Border::everything();
        walk.node(&mut points, &mut intervals, everything, 2, splits);
        pairs.sort();
        assert!(pairs == expected, "after {splits} splits");
    }
}

#[test]
fn a_partition_keeps_everything_and_cuts_where_it_should() {
    for count in 0..20 {
        for pattern in [0, !0, 0b1, 0b1010_1010, 0b1100_1011_1000, 0b1111_1110] {
            let comes_first = |i: &u32| pattern >> i & 1 == 1;
            let mut list: Vec<u32> = (0..count).collect();
            let (first, rest) = partition(&mut list, comes_first);
            assert!(first.iter().all(comes_first));
            assert!(!rest.iter().any(comes_first));
            list.sort();
            assert!(list.iter().copied().eq(0..count), "{pattern:b} of {count}");
        }
    }
}
