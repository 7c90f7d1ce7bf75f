//! The volumes of a range of slots, written in place: that of one thread, or all of them.

use crate::aabb::Aabb;
use crate::real::Real;
use crate::volume::{Ball, VolumeKind};

/// The volumes of a range of slots, numbered from its first one.
pub(crate) struct VolumesChunk<'a, R, const D: usize> {
    pub(super) kinds: &'a [VolumeKind],
    pub(super) balls: &'a mut [Ball<R, D>],
    pub(super) are_stale: &'a mut [bool],
    pub(super) near: &'a [u32],
    pub(super) skin: R,
    pub(super) shortfall: R,
}

impl<R: Real, const D: usize> VolumesChunk<'_, R, D> {
    /// Notes that the collider of the slot `i` is in this box now, if volumes are in use. A ball follows its box, and other volumes become
    /// stale. `has_only_moved` is false if the collider may have changed in any other way. Returns whether the next update must look at the
    /// slot.
    #[inline(always)]
    pub(in crate::pair_tracker) fn follow(
        &mut self,
        i: usize,
        aabb: &Aabb<R, D>,
        has_only_moved: bool,
    ) -> bool {
        let Some(&kind) = self.kinds.get(i) else {
            return false;
        };
        match kind {
            VolumeKind::Ball if has_only_moved && !self.are_stale[i] => {
                let ball = self.balls[i].in_box(&aabb.loosened(self.shortfall));
                if self.balls[i].change_to(&ball) <= self.skin {
                    return false;
                }
                self.balls[i] = ball;
                self.near[i] > 0
            }
            VolumeKind::BoxUntilRead if has_only_moved => false,
            _ => {
                self.are_stale[i] = true;
                // The pairs of other volumes ask for them.
                kind.axes::<D>() == 0 || self.near[i] > 0
            }
        }
    }
}
