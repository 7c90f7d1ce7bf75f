//! What to do with a proxy whose collider has this box now.

use crate::{Aabb, Real};

/// What to do with a proxy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Verdict<R, const D: usize> {
    /// The collider is still inside of the box that is held.
    Keep,
    /// It is not: this box takes its place.
    Renew(Aabb<R, D>),
    /// One of the two boxes is not valid: the collider is new, or to be refused.
    Recheck,
}

impl<R: Real, const D: usize> Verdict<R, D> {
    /// The verdict on a proxy whose box is `held` ([absent](Aabb::ABSENT) if it has none) and should contain `aabb`. A
    /// renewed box is loosened by `margin`.
    #[inline(always)]
    pub(super) fn of(held: &Aabb<R, D>, aabb: &Aabb<R, D>, margin: R) -> Self {
        // Which side is passed first is practically random. One branch on all of them is predicted better than one on
        // each, which the compiler would otherwise make of it.
        if std::hint::black_box(held.contains(aabb) & aabb.is_valid()) {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn verdict(held: Aabb<f32, 1>, aabb: Aabb<f32, 1>) -> Verdict<f32, 1> {
        Verdict::of(&held, &aabb, 0.5)
    }

    #[test]
    fn a_box_is_kept_until_the_collider_leaves_it_and_renewed_with_the_margin() {
        let held = Aabb::new([0.0], [2.0]);
        assert_eq!(verdict(held, Aabb::new([0.0], [2.0])), Verdict::Keep);
        assert_eq!(verdict(held, Aabb::new([0.5], [1.0])), Verdict::Keep);
        let renewed = Verdict::Renew(Aabb::new([0.5], [2.75]));
        assert_eq!(verdict(held, Aabb::new([1.0], [2.25])), renewed);
    }

    #[test]
    fn invalid_and_absent_boxes_are_rechecked() {
        let (held, inverted) = (Aabb::new([0.0], [2.0]), Aabb::new([1.5], [1.0]));
        assert_eq!(verdict(held, inverted), Verdict::Recheck);
        assert_eq!(verdict(held, Aabb::ABSENT), Verdict::Recheck);
        assert_eq!(verdict(Aabb::ABSENT, held), Verdict::Recheck);
        assert_eq!(verdict(Aabb::ABSENT, Aabb::ABSENT), Verdict::Recheck);
    }

    #[test]
    fn a_margin_that_would_spoil_the_box_is_left_out() {
        let all = Aabb::new([f32::NEG_INFINITY], [f32::INFINITY]);
        let held = Aabb::new([0.0], [2.0]);
        assert_eq!(
            Verdict::of(&held, &all, f32::NEG_INFINITY),
            Verdict::Renew(all)
        );
    }
}
