//! Memory grows with boxes and pairs, not with the number of slabs.

use std::num::NonZero;

use unisize::{Aabb, GridSweep, PairFinder};

use crate::allocations::live_bytes;

/// More bytes per box than any of these worlds takes with eight slabs.
const MAX_PER_BOX: usize = 400;

/// Bytes per box, for boxes on a lattice with this spacing.
fn bytes_per_box(slabs: usize, count: usize, distance: f32) -> usize {
    let side = (count as f32).sqrt() as usize;
    let boxes: Vec<_> = (0..count)
        .map(|i| {
            let mins = [0.0, (i % side) as f32, (i / side) as f32].map(|x| x * distance);
            Aabb::new(mins, mins.map(|x| x + 1.0))
        })
        .collect();
    let mut pairs = Vec::new();
    let before = live_bytes();
    let mut kernel = GridSweep::with_slabs(NonZero::new(slabs).expect("the number is not 0"));
    kernel
        .find_pairs(&boxes, &mut pairs)
        .expect("all boxes are valid");
    (live_bytes() - before) / count
}

#[test]
fn memory_does_not_grow_with_the_number_of_slabs() {
    let _turn = crate::turn();
    for count in [1 << 12, 1 << 13, 100_000] {
        // From dense boxes to one box per tube.
        for distance in [0.9, 1.5, 4.0, 6.0, 8.0] {
            let few = bytes_per_box(8, count, distance);
            let many = bytes_per_box(count, count, distance);
            assert!(few.max(many) < MAX_PER_BOX, "{few} and {many} bytes");
        }
    }
}
