//! Whether a proxy keeps its box when its collider has moved.

use crate::aabb::Aabb;
use crate::real::Real;

/// What happens to a box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum BoxUpdate<R, const D: usize> {
    /// It stays, because it still contains the collider.
    Keep,
    /// This box takes its place.
    Renew(Aabb<R, D>),
    /// One of the two boxes is not valid: the collider is new, or must be refused.
    Recheck,
}

impl<R: Real, const D: usize> BoxUpdate<R, D> {
    /// What happens to the box `held` ([absent](Aabb::ABSENT) if there is none) of a collider that has the box `aabb` now. A renewed box is
    /// loosened by `margin`.
    #[inline(always)]
    pub(crate) fn of(held: &Aabb<R, D>, aabb: &Aabb<R, D>, margin: R) -> Self {
        if as_one_branch(held.contains(aabb) & aabb.is_valid()) {
            return Self::Keep;
        }
        if !(held.is_valid() & aabb.is_valid()) {
            return Self::Recheck;
        }
        let loosened = aabb.loosened(margin);
        // An infinite side minus an infinite margin would be NaN.
        Self::Renew(if loosened.is_valid() { loosened } else { *aabb })
    }
}

/// Keeps the compiler from making a branch of each comparison in a condition. Which side of a box is passed first is practically random,
/// so one branch on the whole condition is predicted better.
#[inline(always)]
fn as_one_branch(condition: bool) -> bool {
    std::hint::black_box(condition)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_margin_that_would_spoil_the_box_is_left_out() {
        let all = Aabb::new([f32::NEG_INFINITY], [f32::INFINITY]);
        let update = BoxUpdate::of(&Aabb::new([0.0], [2.0]), &all, f32::NEG_INFINITY);
        assert_eq!(update, BoxUpdate::Renew(all));
    }
}
