//! The volumes of a range of slots, written in place: that of one thread, or all of them.

use crate::aabb::Aabb;
use crate::real::Real;
use crate::volume::{Ball, VolumeKind, VolumeRef};

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
    /// Whether volumes are in use.
    #[inline(always)]
    pub(in crate::pair_tracker) fn are_used(&self) -> bool {
        !self.kinds.is_empty()
    }

    /// Whether the volume of the slot `i` is a part, which stays so until the collider is read again.
    #[inline(always)]
    pub(in crate::pair_tracker) fn is_part(&self, i: usize) -> bool {
        self.kinds.get(i) == Some(&VolumeKind::Part)
    }

    /// Notes that the collider of the slot `i` is in this box now. A ball follows its box, and other volumes become stale. `has_only_moved` is
    /// false if the collider may have changed in any other way. Returns whether the next update must look at the slot.
    #[inline(always)]
    pub(in crate::pair_tracker) fn follow(
        &mut self,
        i: usize,
        aabb: &Aabb<R, D>,
        has_only_moved: bool,
    ) -> bool {
        match self.kinds[i] {
            VolumeKind::Ball if has_only_moved && !self.are_stale[i] => {
                let ball = self.balls[i].in_box(&aabb.loosened(self.shortfall));
                if self.balls[i].change_to(&ball) <= self.skin {
                    return false;
                }
                self.balls[i] = ball;
                self.near[i] > 0
            }
            VolumeKind::Part if has_only_moved => false,
            kind => {
                self.are_stale[i] = true;
                // The pairs of other volumes ask for them.
                kind.axes::<D>() == 0 || self.near[i] > 0
            }
        }
    }
}

/// The volume at `i` of a range of slots.
#[inline(always)]
pub(super) fn volume_of<'a, R: Real, const D: usize>(
    kinds: &[VolumeKind],
    balls: &'a [Ball<R, D>],
    half_axes: &'a [[[R; D]; D]],
    i: usize,
) -> VolumeRef<'a, R, D> {
    let kind = kinds[i];
    VolumeRef {
        kind,
        ball: &balls[i],
        half_axes: match kind.axes::<D>() {
            0 => &[],
            axes => &half_axes[i][..axes],
        },
    }
}
