//! A lower bound on the time to find pairs on this machine.

use std::hint::black_box;
use std::time::{Duration, Instant};
use unisize::Aabb;

/// The width of a strip, in boxes.
const WIDTH: f32 = 12.0;

/// A box and its index.
type Entry<const D: usize> = (Aabb<f32, D>, u32);

fn nothing<const D: usize>() -> Entry<D> {
    (Aabb::new([0.0; D], [0.0; D]), 0)
}

/// The strip of a box along the second axis.
#[inline(always)]
fn strip<const D: usize>(aabb: &Aabb<f32, D>) -> usize {
    (aabb.mins[1] * (1.0 / WIDTH)) as usize
}

/// How many strips there are.
fn strips<const D: usize>(boxes: &[Aabb<f32, D>]) -> usize {
    boxes.iter().map(strip).max().map_or(0, |last| last + 1)
}

/// Memory kept from call to call.
#[derive(Default)]
pub(crate) struct Floor<const D: usize> {
    /// Where the next box of each strip goes.
    cursors: Vec<u32>,
    sorted: Vec<Entry<D>>,
    pairs: Vec<[u32; 2]>,
}

impl<const D: usize> Floor<D> {
    /// How long it takes to read the boxes, to move them to their strips along the second axis, and to write the pairs. How many
    /// strips there are is known beforehand.
    pub(crate) fn measure(&mut self, boxes: &[Aabb<f32, D>], pairs: &[[u32; 2]]) -> Duration {
        let strips = strips(boxes);
        self.sorted.resize(boxes.len(), nothing());
        let start = Instant::now();
        self.sort(boxes, strips);
        self.pairs.clear();
        self.pairs.extend_from_slice(pairs);
        black_box((&self.sorted, &self.pairs));
        start.elapsed()
    }

    fn sort(&mut self, boxes: &[Aabb<f32, D>], strips: usize) {
        let Self {
            cursors, sorted, ..
        } = self;
        cursors.clear();
        cursors.resize(strips, 0);
        for aabb in boxes {
            cursors[strip(aabb)] += 1;
        }
        // Counts become where the first of each strip goes.
        let mut end = 0;
        for count in &mut *cursors {
            end += std::mem::replace(count, end);
        }
        for (aabb, index) in boxes.iter().zip(0..) {
            let cursor = &mut cursors[strip(aabb)];
            sorted[*cursor as usize] = (*aabb, index);
            *cursor += 1;
        }
    }
}
