//! What must hold for inputs that must be refused.

use crate::numbers::Number;
use unisize::InvalidInputReason::{Inverted, NotANumber};
use unisize::{Aabb, InvalidInputReason, PairFinder};

use crate::check::{JUNK, find};
use crate::numbers::stepped;
use crate::placement::uniform;

/// Checks that one invalid box anywhere is named, that no pair is given, and that the finder then goes on.
pub(crate) fn check<F, R, const D: usize>()
where
    F: PairFinder<R, D> + Default,
    R: Number,
{
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
            assert!(after == pairs, "after an error the answer is another");
        }
    }
}

/// Checks that the finder refuses the boxes for what is wrong with the one at `index`.
fn refuses<F, R, const D: usize>(
    finder: &mut F,
    boxes: &[Aabb<R, D>],
    index: usize,
    reason: InvalidInputReason,
) where
    F: PairFinder<R, D>,
    R: Number,
{
    let mut pairs = JUNK.to_vec();
    let error = finder
        .find_pairs(boxes, &mut pairs)
        .expect_err("an invalid box was accepted");
    let bad = boxes[index];
    assert_eq!((error.index, error.reason), (index, reason), "{bad:?}");
    assert!(pairs.is_empty(), "pairs were left after an error: {bad:?}");
}

/// Everything that can be wrong with a box, on each axis, with a name.
fn invalid_versions<R: Number, const D: usize>(
    valid: Aabb<R, D>,
) -> Vec<(Aabb<R, D>, InvalidInputReason)> {
    let nan = R::from_f64(f64::NAN);
    let negative_nan = R::from_f64(-f64::NAN);
    let mut versions = Vec::new();
    for axis in 0..D {
        let low = valid.mins[axis];
        let sides = [
            (nan, valid.maxs[axis], NotANumber { axis }),
            (low, nan, NotANumber { axis }),
            (negative_nan, valid.maxs[axis], NotANumber { axis }),
            (low, negative_nan, NotANumber { axis }),
            (nan, nan, NotANumber { axis }),
            (R::from_f64(f64::NEG_INFINITY), nan, NotANumber { axis }),
            (nan, R::from_f64(f64::INFINITY), NotANumber { axis }),
            (low + R::from_f64(1.0), low, Inverted { axis }),
            (low, stepped(low, -1), Inverted { axis }),
            (R::from_f64(f64::INFINITY), low, Inverted { axis }),
            (low, R::from_f64(f64::NEG_INFINITY), Inverted { axis }),
            (
                R::from_f64(f64::INFINITY),
                R::from_f64(f64::NEG_INFINITY),
                Inverted { axis },
            ),
            (
                R::from_f64(0.0).successor(),
                R::from_f64(0.0),
                Inverted { axis },
            ),
        ];
        for (low, high, reason) in sides {
            let mut version = valid;
            version.mins[axis] = low;
            version.maxs[axis] = high;
            versions.push((version, reason));
            // Being flat on the others is valid.
            for other in (0..D).filter(|&other| other != axis) {
                version.maxs[other] = version.mins[other];
            }
            versions.push((version, reason));
        }
    }
    versions
}
