//! A lower bound on the time to find pairs on this machine.

use std::hint::black_box;
use std::time::{Duration, Instant};
use unisize::Aabb;

/// The width of a strip, in boxes.
const WIDTH: f32 = 12.0;

/// Memory kept from call to call.
#[derive(Default)]
pub(crate) struct Floor<const D: usize> {
    /// Where the next box of each strip goes.
    cursors: Vec<u32>,
    sorted: Vec<(Aabb<f32, D>, u32)>,
    pairs: Vec<[u32; 2]>,
}

impl<const D: usize> Floor<D> {
    /// How long it takes to read the boxes, to move them to their strips along the second axis, and to write the pairs.
    pub(crate) fn measure(&mut self, boxes: &[Aabb<f32, D>], pairs: &[[u32; 2]]) -> Duration {
        let Self {
            cursors,
            sorted,
            pairs: written,
        } = self;
        sorted.resize(boxes.len(), (Aabb::new([0.0; D], [0.0; D]), 0));
        let start = Instant::now();
        let mut high = 0.0_f32;
        for aabb in boxes {
            high = high.max(aabb.maxs[1]);
        }
        let strip = |aabb: &Aabb<f32, D>| (aabb.mins[1] * (1.0 / WIDTH)) as usize;
        cursors.clear();
        cursors.resize((high / WIDTH) as usize + 1, 0);
        for aabb in boxes {
            cursors[strip(aabb)] += 1;
        }
        let mut end = 0;
        for cursor in cursors.iter_mut() {
            end += std::mem::replace(cursor, end);
        }
        for (aabb, index) in boxes.iter().zip(0..) {
            let cursor = &mut cursors[strip(aabb)];
            sorted[*cursor as usize] = (*aabb, index);
            *cursor += 1;
        }
        written.clear();
        written.extend_from_slice(pairs);
        black_box((&sorted, &written));
        start.elapsed()
    }
}
