//! The checks of invalid inputs.

use unisize::InvalidInputReason::{Inverted, NotANumber};
use unisize::{Aabb, InvalidInputReason, PairFinder};

use crate::boxes::uniform;
use crate::check::{JUNK, find};
use crate::numbers::{Number, stepped};

/// Checks that the error has the index of the invalid box, that there are no pairs, and that the finder works afterwards.
pub(crate) fn check<F: PairFinder<R, D> + Default, R: Number, const D: usize>() {
    for n in [1, 9, 200] {
        let valid = uniform(n as u64, n, 0.8);
        let mut finder = F::default();
        let pairs = find(&mut finder, &valid).expect("the boxes are valid");
        for index in [0, n / 2, n - 1] {
            for (bad, reason) in invalid_versions(valid[index]) {
                let mut boxes = valid.clone();
                boxes[index] = bad;
                // Only the first invalid box counts.
                boxes.push(Aabb::new(
                    [R::from_f64(f64::INFINITY); D],
                    [R::from_f64(f64::NEG_INFINITY); D],
                ));
                refuses(&mut finder, &boxes, index, reason);
                refuses(&mut F::default(), &boxes, index, reason);
            }
            let after = find(&mut finder, &valid).expect("the boxes are valid");
            assert!(after == pairs, "after an error the pairs differ");
        }
    }
}

/// Checks that the error is for the box at `index`, with this reason.
fn refuses<F: PairFinder<R, D>, R: Number, const D: usize>(
    finder: &mut F,
    boxes: &[Aabb<R, D>],
    index: usize,
    reason: InvalidInputReason,
) {
    let mut pairs = JUNK.to_vec();
    let error = finder
        .find_pairs(boxes, &mut pairs)
        .expect_err("an invalid box was accepted");
    let bad = boxes[index];
    assert_eq!((error.index, error.reason), (index, reason), "{bad:?}");
    assert!(pairs.is_empty(), "pairs were left after an error: {bad:?}");
}

/// All kinds of invalid boxes, on each axis, with the reasons.
fn invalid_versions<R: Number, const D: usize>(
    valid: Aabb<R, D>,
) -> Vec<(Aabb<R, D>, InvalidInputReason)> {
    let numbers = [f64::NAN, -f64::NAN, f64::NEG_INFINITY, f64::INFINITY, 0.0];
    let [nan, negative_nan, below, above, zero] = numbers.map(R::from_f64);
    let mut versions = Vec::new();
    for axis in 0..D {
        let (low, high) = (valid.mins[axis], valid.maxs[axis]);
        let no_numbers = [
            (nan, high),
            (low, nan),
            (negative_nan, high),
            (low, negative_nan),
            (nan, nan),
            (below, nan),
            (nan, above),
        ];
        let inverted = [
            (low + R::from_f64(1.0), low),
            (low, stepped(low, -1)),
            (above, low),
            (low, below),
            (above, below),
            (zero.successor(), zero),
        ];
        let no_numbers = no_numbers.map(|sides| (sides, NotANumber { axis }));
        let inverted = inverted.map(|sides| (sides, Inverted { axis }));
        for (sides, reason) in no_numbers.into_iter().chain(inverted) {
            let mut version = valid;
            (version.mins[axis], version.maxs[axis]) = sides;
            versions.push((version, reason));
            // A box that is flat on the other axes would be valid.
            for other in (0..D).filter(|&other| other != axis) {
                version.maxs[other] = version.mins[other];
            }
            versions.push((version, reason));
        }
    }
    versions
}
