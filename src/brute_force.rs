//! The oracle: every box against every other.

use crate::aabb::Aabb;
use crate::invalid_input::InvalidInput;
use crate::pair_finder::{PairFinder, check_boxes, check_count};
use crate::real::Real;

/// Tests every box against every other, in **O(n²)** time and no memory.
///
/// Short enough to be seen to be correct, it is what every other kernel is compared with.
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
