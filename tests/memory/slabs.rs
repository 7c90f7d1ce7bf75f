//! However many slabs are asked for, memory grows with the boxes and the pairs.

use std::num::NonZero;

use unisize::{Aabb, GridSweep, PairFinder};

use crate::allocations::live_bytes;

/// Above what any of these worlds takes with eight slabs.
const MOST_A_BOX: usize = 400;

/// Memory for each box with so many slabs, if boxes have this distance from each other.
fn bytes_a_box(slabs: usize, count: usize, distance: f32) -> usize {
    let side = (count as f32).sqrt() as usize;
    let boxes: Vec<_> = (0..count)
        .map(|i| {
            let mins = [0.0, (i % side) as f32, (i / side) as f32].map(|x| x * distance);
            Aabb::new(mins, mins.map(|x| x + 1.0))
        })
        .collect();
    let mut pairs = Vec::new();
    let before = live_bytes();
    let mut kernel = GridSweep::with_slabs(NonZero::new(slabs).expect("there are slabs"));
    kernel
        .find_pairs(&boxes, &mut pairs)
        .expect("all are valid");
    (live_bytes() - before) / count
}

#[test]
fn memory_does_not_follow_the_number_of_slabs() {
    let _turn = crate::turn();
    for count in [1 << 12, 1 << 13, 100_000] {
        // From dense boxes to one tube a box.
        for distance in [0.9, 1.5, 4.0, 6.0, 8.0] {
            let few = bytes_a_box(8, count, distance);
            let many = bytes_a_box(count, count, distance);
            assert!(few.max(many) < MOST_A_BOX, "{few} and {many} bytes");
        }
    }
}
