//! Sets of pairs of indices, to compare what one found with what another did.

use unisize::{Aabb, BruteForce, GridSweep, InvalidInput, PairFinder};

/// Up to so many boxes, every one is compared with every other.
const BRUTE_FORCE_MAX: usize = 1 << 14;

/// Pairs of indices, each with the smaller index first, in ascending order.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct PairSet(Vec<[u32; 2]>);

impl PairSet {
    /// Pairs in any order; a pair that is there twice stays so, and makes the set unequal to a sound one.
    pub(crate) fn new(pairs: impl IntoIterator<Item = [u32; 2]>) -> Self {
        let ordered = |[a, b]: [u32; 2]| [a.min(b), a.max(b)];
        let mut pairs: Vec<_> = pairs.into_iter().map(ordered).collect();
        pairs.sort_unstable();
        Self(pairs)
    }

    /// The oracle's: by brute force, or, of more boxes than that is possible for, by the kernel that the tests
    /// compare with brute force.
    pub(crate) fn of_boxes<const D: usize>(boxes: &[Aabb<f32, D>]) -> Result<Self, InvalidInput> {
        let mut pairs = Vec::new();
        if boxes.len() <= BRUTE_FORCE_MAX {
            BruteForce.find_pairs(boxes, &mut pairs)?;
        } else {
            GridSweep::default().find_pairs(boxes, &mut pairs)?;
        }
        Ok(Self::new(pairs))
    }

    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    /// How many of these are not in the other set.
    pub(crate) fn missing_in(&self, other: &Self) -> usize {
        let missing = |pair: &&[u32; 2]| other.0.binary_search(pair).is_err();
        self.0.iter().filter(missing).count()
    }

    /// Says what differs, if anything does.
    pub(crate) fn difference(&self, expected: &Self) -> Option<String> {
        (self != expected).then(|| {
            format!(
                "{} pairs instead of {}: {} missing, {} spurious",
                self.len(),
                expected.len(),
                expected.missing_in(self),
                self.missing_in(expected),
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::PairSet;

    #[test]
    fn order_does_not_matter_and_repetition_does() {
        let set = PairSet::new([[1, 2], [3, 0]]);
        assert_eq!(PairSet::new([[0, 3], [2, 1]]).difference(&set), None);
        assert!(
            PairSet::new([[0, 3], [2, 1], [1, 2]])
                .difference(&set)
                .is_some()
        );
        assert_eq!(set.missing_in(&PairSet::new([[1, 2]])), 1);
    }
}
