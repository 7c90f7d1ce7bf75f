//! The volumes of a range of slots, written in place: that of one thread, or all of them.

use crate::aabb::Aabb;
use crate::pair_tracker::odometer::Odometer;
use crate::real::Real;
use crate::volume::{Ball, Volume, VolumeKind, VolumeRef};

/// The volumes of a range of slots, numbered from its first one. Their kinds stay.
pub(crate) struct VolumesChunk<'a, R, const D: usize> {
    pub(super) kinds: &'a [VolumeKind],
    pub(super) balls: &'a mut [Ball<R, D>],
    pub(super) half_axes: &'a mut [[[R; D]; D]],
    pub(super) are_slow: &'a mut [bool],
    /// Empty if they stand still.
    pub(super) odometers: &'a mut [Odometer],
    pub(super) margin: R,
    pub(super) shortfall: R,
}

/// What happens to a volume when its collider has moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum VolumeUpdate {
    /// It stays as it is.
    Keep,
    /// It stays, and is loosened by the margin from now on.
    Loosen,
    /// The collider's volume takes its place.
    Replace,
}

impl VolumeUpdate {
    /// Whether pairs of the volume may begin or end.
    #[inline(always)]
    pub(in crate::pair_tracker) fn concerns_pairs(self) -> bool {
        self != Self::Keep
    }
}

impl<R: Real, const D: usize> VolumesChunk<'_, R, D> {
    #[inline(always)]
    pub(in crate::pair_tracker) fn are_used(&self) -> bool {
        !self.kinds.is_empty()
    }

    /// The volume of the slot `i` in this box, if it follows from the box.
    #[inline(always)]
    pub(in crate::pair_tracker) fn by_box(
        &self,
        i: usize,
        aabb: &Aabb<R, D>,
    ) -> Option<Volume<R, D>> {
        match self.kinds.get(i)? {
            VolumeKind::Part => Some(Volume::PART),
            VolumeKind::Ball => Some(Volume {
                kind: VolumeKind::Ball,
                ball: self.ball_in(i, aabb),
                ..Volume::BOX
            }),
            _ => None,
        }
    }

    /// Brings the volume of the slot `i` up to date with that of its collider. `is_renewed` says whether its box is renewed. Returns
    /// `None`, and changes nothing, if the collider's volume is of another kind.
    #[inline(always)]
    pub(crate) fn set(
        &mut self,
        i: usize,
        volume: &Volume<R, D>,
        is_renewed: bool,
    ) -> Option<VolumeUpdate> {
        let kind = volume.kind;
        if kind != self.kinds[i] {
            return None;
        }
        if matches!(kind, VolumeKind::Box | VolumeKind::Part) && !is_renewed {
            return Some(VolumeUpdate::Keep);
        }
        let former = volume_of(self.kinds, self.balls, self.half_axes, i);
        let change = former.change_to(volume.as_ref());
        let update = self.update_for(i, change, is_renewed);
        if update == VolumeUpdate::Replace {
            if kind.axes::<D>() > 0 {
                self.half_axes[i] = volume.half_axes;
            }
            self.balls[i] = volume.ball;
        }
        Some(update)
    }

    /// The same for a collider with this box; `None`, and nothing changes, if its volume does not follow from the box.
    #[inline(always)]
    pub(crate) fn set_by_box(
        &mut self,
        i: usize,
        aabb: &Aabb<R, D>,
        is_renewed: bool,
    ) -> Option<VolumeUpdate> {
        match self.kinds[i] {
            VolumeKind::Part => Some(VolumeUpdate::Keep),
            VolumeKind::Ball => {
                let ball = self.ball_in(i, aabb);
                let change = self.balls[i].change_to(&ball);
                let update = self.update_for(i, change, is_renewed);
                if update == VolumeUpdate::Replace {
                    self.balls[i] = ball;
                }
                Some(update)
            }
            _ => None,
        }
    }

    /// The ball of the slot `i` in this box of a collider.
    #[inline(always)]
    fn ball_in(&self, i: usize, aabb: &Aabb<R, D>) -> Ball<R, D> {
        self.balls[i].in_box(&aabb.loosened(self.shortfall))
    }

    /// What happens to the volume of the slot `i` if its collider differs from it by `change`. Notes whether it is slow, and advances its
    /// odometer.
    #[inline(always)]
    fn update_for(&mut self, i: usize, change: R, is_renewed: bool) -> VolumeUpdate {
        if change <= self.margin && !is_renewed {
            let is_slow = self.are_slow[i] | (change > R::ZERO);
            if !(is_slow & !std::mem::replace(&mut self.are_slow[i], is_slow)) {
                return VolumeUpdate::Keep;
            }
            self.advance(i, self.margin);
            return VolumeUpdate::Loosen;
        }
        self.advance(i, change);
        if is_renewed & self.are_slow[i] {
            // It is no longer loosened.
            self.advance(i, self.margin);
        }
        self.are_slow[i] &= !is_renewed;
        VolumeUpdate::Replace
    }

    /// Advances the odometer of the slot `i`, unless odometers stand still.
    #[inline(always)]
    fn advance(&mut self, i: usize, by: R) {
        if let Some(odometer) = self.odometers.get_mut(i) {
            odometer.advance(by);
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
