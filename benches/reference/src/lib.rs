//! Sweep and prune, which Capannini and Larsson, *Output Sensitive Collision Detection for Unisize Boxes*, compare themselves with, as a
//! [`PairFinder`](unisize::PairFinder).
//!
//! It is exact and passes the tests of every kernel, but is here only to be compared with. Endpoints are sorted by a radix sort, as in
//! the paper and in `RankSweep`, so that what is compared is the search.

mod active_list;
mod sweep_and_prune;

pub use sweep_and_prune::SweepAndPrune;

use unisize::{Aabb, InvalidInput, InvalidInputReason, Real};

/// Two endpoints a box, numbered by `u32`, with one number to spare.
const MAX_BOXES: usize = (u32::MAX / 2) as usize;

/// Checks what [`find_pairs`](unisize::PairFinder::find_pairs) requires of its input.
fn check_boxes<R: Real, const D: usize>(boxes: &[Aabb<R, D>]) -> Result<(), InvalidInput> {
    if boxes.len() > MAX_BOXES {
        return Err(InvalidInput::new(MAX_BOXES, InvalidInputReason::TooMany));
    }
    for (index, Aabb { mins, maxs }) in boxes.iter().enumerate() {
        for axis in 0..D {
            if mins[axis] <= maxs[axis] {
                continue;
            }
            let reason = if mins[axis] > maxs[axis] {
                InvalidInputReason::Inverted { axis }
            } else {
                InvalidInputReason::NotANumber { axis }
            };
            return Err(InvalidInput::new(index, reason));
        }
    }
    Ok(())
}

/// The pair of two different indices, smaller first.
#[inline]
fn ordered(a: u32, b: u32) -> [u32; 2] {
    [a.min(b), a.max(b)]
}
