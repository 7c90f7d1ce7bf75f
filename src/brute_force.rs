//! The oracle: compares every box with every other.

use crate::aabb::Aabb;
use crate::invalid_input::InvalidInput;
use crate::pair_finder::{PairFinder, check_boxes, check_count};
use crate::real::Real;

/// Compares every box with every other.
///
/// Computes in **O(n²)** time and needs no memory besides the pairs. It is so short that one can see that it is correct, so tests compare
/// all other kernels with it. Takes at most 2³² - 1 boxes and refuses more as [`TooMany`](crate::InvalidInputReason::TooMany).
#[derive(Clone, Copy, Debug, Default)]
pub struct BruteForce;

impl<R: Real, const D: usize> PairFinder<R, D> for BruteForce {
    fn find_pairs(
        &mut self,
        boxes: &[Aabb<R, D>],
        pairs: &mut Vec<[u32; 2]>,
    ) -> Result<(), InvalidInput> {
        pairs.clear();
        check_count(boxes.len(), u32::MAX as usize)?;
        check_boxes(boxes)?;
        for (i, a) in boxes.iter().enumerate() {
            for (j, b) in boxes.iter().enumerate().skip(i + 1) {
                if a.intersects(b) {
                    pairs.push([i as u32, j as u32]);
                }
            }
        }
        Ok(())
    }
}
