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
    /// What happens to the `present` box ([absent](Aabb::ABSENT) if there is none) of a collider that has the box `aabb` now. A renewed box is
    /// loosened by `margin`.
    #[inline(always)]
    pub(crate) fn of(present: &Aabb<R, D>, aabb: &Aabb<R, D>, margin: R) -> Self {
        // Which side of a box is passed first is practically random. So `black_box` keeps the compiler from making a branch of each comparison:
        // one branch on the whole condition is predicted better.
        if std::hint::black_box(present.contains(aabb) & aabb.is_valid()) {
            return Self::Keep;
        }
        if !(present.is_valid() & aabb.is_valid()) {
            return Self::Recheck;
        }
        let loosened = aabb.loosened(margin);
        // An infinite side minus an infinite margin would be NaN.
        Self::Renew(if loosened.is_valid() { loosened } else { *aabb })
    }
}
