//! Sets of pairs of indices, to compare what one found with what another did: each pair with the smaller index first, in ascending order.

use unisize::{Aabb, BruteForce, GridSweep, InvalidInput, PairFinder};

/// Up to so many boxes, every one is compared with every other.
const BRUTE_FORCE_MAX: usize = 1 << 14;

/// The set of pairs in any order; a pair that is there twice stays so, and makes the set unequal to a sound one.
pub(crate) fn ordered(pairs: &[[u32; 2]]) -> Vec<[u32; 2]> {
    let ordered = |&[a, b]: &[u32; 2]| [a.min(b), a.max(b)];
    let mut pairs: Vec<_> = pairs.iter().map(ordered).collect();
    pairs.sort_unstable();
    pairs
}

/// The oracle's: by brute force, or, of more boxes than that is possible for, by the kernel that the tests
/// compare with brute force.
pub(crate) fn of_boxes<const D: usize>(
    boxes: &[Aabb<f32, D>],
) -> Result<Vec<[u32; 2]>, InvalidInput> {
    let mut pairs = Vec::new();
    if boxes.len() <= BRUTE_FORCE_MAX {
        BruteForce.find_pairs(boxes, &mut pairs)?;
    } else {
        GridSweep::default().find_pairs(boxes, &mut pairs)?;
    }
    Ok(ordered(&pairs))
}

/// Says what differs, if anything does.
pub(crate) fn difference(found: &[[u32; 2]], expected: &[[u32; 2]]) -> Option<String> {
    let only_in = |set: &[[u32; 2]], other: &[[u32; 2]]| {
        let is_missing = |pair: &&[u32; 2]| other.binary_search(pair).is_err();
        set.iter().filter(is_missing).count()
    };
    (found != expected).then(|| {
        format!(
            "{} pairs instead of {}: {} missing, {} spurious",
            found.len(),
            expected.len(),
            only_in(expected, found),
            only_in(found, expected),
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn order_does_not_matter_and_repetition_does() {
        let set = ordered(&[[1, 2], [3, 0]]);
        assert_eq!(difference(&ordered(&[[0, 3], [2, 1]]), &set), None);
        assert!(difference(&ordered(&[[0, 3], [2, 1], [1, 2]]), &set).is_some());
        let differing = difference(&[[1, 2]], &set).unwrap();
        assert!(differing.ends_with("1 missing, 0 spurious"));
    }
}
