//! `GridSweep` with several slabs, as it runs on several threads.

use std::num::NonZero;

use crate::numbers::Number;
use unisize::{Aabb, GridSweep, InvalidInput, PairFinder};

/// [`GridSweep`] with three slabs, which must find the same pairs in the same order as with one.
pub(crate) struct InSlabs<R, const D: usize> {
    one: GridSweep<R, D>,
    three: GridSweep<R, D>,
    expected: Vec<[u32; 2]>,
}

impl<R: Number, const D: usize> Default for InSlabs<R, D> {
    fn default() -> Self {
        let [one, three] = [1, 3]
            .map(|count| GridSweep::with_slabs(NonZero::new(count).expect("the number is not 0")));
        Self {
            one,
            three,
            expected: Vec::new(),
        }
    }
}

impl<R: Number, const D: usize> PairFinder<R, D> for InSlabs<R, D> {
    fn find_pairs(
        &mut self,
        boxes: &[Aabb<R, D>],
        pairs: &mut Vec<[u32; 2]>,
    ) -> Result<(), InvalidInput> {
        let expected = self.one.find_pairs(boxes, &mut self.expected);
        let found = self.three.find_pairs(boxes, pairs);
        assert_eq!(found, expected);
        assert!(*pairs == self.expected, "the pairs or their order differ");
        found
    }
}
