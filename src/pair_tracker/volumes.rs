//! The bounding volumes of all slots, if volumes are in use.
//!
//! Boxes are pushed, volumes are pulled: see ARCHITECTURE.md. After an update, the volumes of *near* pairs, whose boxes overlap and that are
//! not held, are those of the colliders. A ball takes a kind, a centre and a radius. Half axes are kept only up to the highest slot that has
//! ever had some.

use super::Colliders;
use crate::aabb::max;
use crate::parallel::Section;
use crate::real::Real;
use crate::tuning::prices::{BEYOND_BALLS, READ};
use crate::volume::{Ball, Volume, VolumeKind, VolumeRef};

/// The skin of a volume, in margins of a box. If larger: more pairs begin that are near and do not touch. If smaller: more pairs of proxies
/// that come to rest are asked in each update. Events depend on it.
const SKIN: f64 = 0.0625;

/// The least factor by which a skin or a reach grows. All volumes are read again when one does. If larger: more pairs begin that are near
/// and do not touch. If smaller: volumes are read more often where a parameter grows in every frame. Events depend on it.
const GROWTH: f64 = 2.0;

/// Volumes by slot; none unless they are in use.
#[derive(Clone, Debug, Default)]
pub(crate) struct Volumes<R, const D: usize> {
    pub(crate) are_used: bool,
    kinds: Vec<VolumeKind>,
    balls: Vec<Ball<R, D>>,
    /// Of the first slots; no volume of a higher slot has any.
    half_axes: Vec<[[R; D]; D]>,
    /// Whether the collider may have moved, or changed, since its volume was read.
    are_stale: Vec<bool>,
    /// In how many pairs each slot is near another one.
    pub(super) near: Vec<u32>,
    /// The largest skin so far.
    skin: R,
    /// The largest distance so far by which all shapes are extended, without the skin. Volumes are read with it even while the parameters ask
    /// for less, so that parameters may alternate, and any two volumes are right for the larger ones.
    reach: R,
    /// How much farther volumes are extended than boxes.
    shortfall: R,
}

/// A chunk of the volumes, numbered from its first slot; empty if volumes are not in use.
pub(super) struct VolumesChunk<'a, R, const D: usize> {
    pub(super) kinds: &'a [VolumeKind],
    pub(super) balls: &'a mut [Ball<R, D>],
    pub(super) are_stale: &'a mut [bool],
    pub(super) near: &'a [u32],
    pub(super) skin: R,
    pub(super) shortfall: R,
}

/// The serialized form of volumes.
#[cfg(feature = "serde-serialize")]
#[derive(serde::Serialize, serde::Deserialize)]
pub(crate) struct VolumesSnapshot<R> {
    /// `None` if it is infinite.
    skin: Option<R>,
    /// `None` if it is infinite.
    reach: Option<R>,
    /// For each slot the kind, whether it is stale, and the numbers; empty if volumes are not in use.
    by_slot: Vec<(VolumeKind, bool, Vec<R>)>,
}

impl<R: Real, const D: usize> Volumes<R, D> {
    /// Notes the margin of boxes, and the distance by which they are extended. Returns whether either [has
    /// grown](Self::have_longer_extents); then all volumes are stale, and [`pull`](Self::pull) must read them.
    pub(super) fn note_extents(&mut self, margin: R, reach: R) -> bool {
        let have_grown = self.have_longer_extents(margin, reach);
        if have_grown {
            self.skin = at_least(self.skin, margin * R::from_f64(SKIN));
            self.reach = at_least(self.reach, reach);
            self.are_stale.fill(true);
            // No volume is as loose as the skin allows, so none may stay.
            for ball in &mut self.balls {
                ball.center = [R::NAN; D];
            }
        }
        have_grown
    }

    /// Notes the distance by which the next boxes are extended.
    pub(crate) fn note_reach_of_boxes(&mut self, reach: R) {
        // A NaN counts as 0.
        self.shortfall = max(self.extension() - reach, R::ZERO);
    }

    /// Whether volumes are in use, and the margin or the reach is larger than the noted one.
    pub(crate) fn have_longer_extents(&self, margin: R, reach: R) -> bool {
        self.are_used && (margin * R::from_f64(SKIN) > self.skin || reach > self.reach)
    }

    /// The distance by which the volumes of all shapes are extended.
    pub(crate) fn extension(&self) -> R {
        self.reach + self.skin
    }

    /// Counts a pair as near, or no longer.
    #[inline(always)]
    pub(super) fn note_near(&mut self, pair: [u32; 2], is_near: bool) {
        for slot in pair {
            if let Some(near) = self.near.get_mut(slot as usize) {
                *near = if is_near { *near + 1 } else { *near - 1 };
            }
        }
    }

    /// The price of an item of work, given its price where all volumes are balls.
    pub(crate) fn price(&self, of_balls: u64) -> u64 {
        match self.half_axes.is_empty() {
            true => of_balls,
            false => BEYOND_BALLS * of_balls,
        }
    }

    pub(super) fn make_room(&mut self, slots: usize) {
        if self.are_used && slots > self.kinds.len() {
            self.kinds.resize(slots, VolumeKind::Box);
            self.balls.resize(slots, Volume::BOX.ball);
            self.are_stale.resize(slots, false);
            self.near.resize(slots, 0);
        }
    }

    /// The volume of a slot, for which there must be room.
    #[inline(always)]
    pub(crate) fn get(&self, slot: u32) -> VolumeRef<'_, R, D> {
        let i = slot as usize;
        let kind = self.kinds[i];
        VolumeRef {
            kind,
            ball: &self.balls[i],
            half_axes: match kind.axes::<D>() {
                0 => &[],
                axes => &self.half_axes[i][..axes],
            },
        }
    }

    /// Whether one of a pair has a stale volume.
    #[inline(always)]
    pub(super) fn are_stale(&self, pair: [u32; 2]) -> bool {
        let [a, b] = pair.map(|slot| self.are_stale[slot as usize]);
        a | b
    }

    /// Reads the stale volumes of these slots, in the order of slots. Drops the slots whose stale volume has turned out the same.
    pub(super) fn pull(&mut self, slots: &mut Vec<u32>, colliders: &impl Colliders<R, D>) {
        slots.sort_unstable();
        slots.dedup();
        let section = Section::of(slots.len(), BEYOND_BALLS * READ);
        if section.parts() == 1 {
            return slots.retain(|&slot| {
                // A ball that has followed its box is not stale.
                let is_stale = std::mem::take(&mut self.are_stale[slot as usize]);
                !is_stale || self.set(slot, &colliders.volume(slot))
            });
        }
        let slots_a_part = slots.len().div_ceil(section.parts());
        let parts = slots.chunks(slots_a_part).map(|slots| (slots, Vec::new()));
        let mut parts: Vec<_> = parts.collect();
        let volumes = &*self;
        section.for_each(&mut parts, |(slots, read)| {
            let is_stale = |slot: &&u32| volumes.are_stale[**slot as usize];
            let stale = slots.iter().filter(is_stale);
            read.extend(stale.map(|&slot| colliders.volume(slot)));
        });
        let read: Vec<_> = parts.into_iter().flat_map(|(_, read)| read).collect();
        let mut read = read.into_iter();
        slots.retain(|&slot| {
            let is_stale = std::mem::take(&mut self.are_stale[slot as usize]);
            let volume = if is_stale { read.next() } else { None };
            volume.is_none_or(|volume| self.set(slot, &volume))
        });
    }

    /// Sets the volume of a slot, for which there must be room. It stays if it differs by no more than the skin. Returns whether it has
    /// changed.
    #[inline(always)]
    fn set(&mut self, slot: u32, volume: &Volume<R, D>) -> bool {
        let i = slot as usize;
        if volume.kind != self.kinds[i] {
            self.set_kind(i, volume.kind);
        } else if matches!(volume.kind, VolumeKind::Box | VolumeKind::BoxUntilRead) {
            return false;
        } else {
            let change = self.get(slot).change_to(volume.as_ref());
            // A ball with the radius of a smaller box would not fill its own.
            let is_ball_as_before =
                volume.kind != VolumeKind::Ball || volume.ball.radius == self.balls[i].radius;
            if change <= self.skin && is_ball_as_before {
                return false;
            }
        }
        if volume.kind.axes::<D>() > 0 {
            self.half_axes[i] = volume.half_axes;
        }
        self.balls[i] = volume.ball;
        true
    }

    /// Sets the kind of a volume, and makes room for its half axes.
    #[cold]
    fn set_kind(&mut self, i: usize, kind: VolumeKind) {
        self.kinds[i] = kind;
        if kind.axes::<D>() > 0 && i >= self.half_axes.len() {
            self.half_axes.resize(i + 1, Volume::<R, D>::BOX.half_axes);
        }
    }

    /// The serialized form of all volumes.
    #[cfg(feature = "serde-serialize")]
    pub(super) fn snapshot(&self) -> VolumesSnapshot<R> {
        let slots = 0..self.kinds.len() as u32;
        let volumes = slots.map(|slot| (self.get(slot), self.are_stale[slot as usize]));
        VolumesSnapshot {
            // Some formats have no infinity.
            skin: self.skin.is_finite().then_some(self.skin),
            reach: self.reach.is_finite().then_some(self.reach),
            by_slot: volumes
                .map(|(volume, is_stale)| (volume.kind, is_stale, volume.numbers()))
                .collect(),
        }
    }

    /// Restores the volumes of this number of slots, for which there must be room, or says why none have this serialized form.
    #[cfg(feature = "serde-serialize")]
    pub(super) fn restore(
        &mut self,
        snapshot: VolumesSnapshot<R>,
        slots: usize,
    ) -> Result<(), &'static str> {
        if snapshot.by_slot.len() != if self.are_used { slots } else { 0 } {
            return Err("snapshot: there is not one volume for each slot");
        }
        self.skin = snapshot.skin.unwrap_or(R::INFINITY);
        self.reach = snapshot.reach.unwrap_or(R::INFINITY);
        let are_distances = self.skin >= R::ZERO && self.reach >= R::ZERO;
        if !are_distances {
            return Err("snapshot: the skin or the reach of volumes is not a distance");
        }
        for (slot, (kind, is_stale, numbers)) in (0..).zip(snapshot.by_slot) {
            let volume = Volume::of_numbers(kind, &numbers);
            let volume =
                volume.ok_or("snapshot: a volume has other numbers than its kind can have")?;
            // All kinds are new.
            self.set(slot, &volume);
            self.are_stale[slot as usize] = is_stale;
        }
        Ok(())
    }

    /// Forgets the volume of a slot whose proxy is removed, so that the pairs of the next one there do not depend on it.
    pub(super) fn forget(&mut self, slot: u32) {
        if self.are_used {
            self.set_kind(slot as usize, VolumeKind::Box);
            self.balls[slot as usize] = Volume::BOX.ball;
        }
    }

    /// Chunks of this many slots, followed by empty ones without end.
    pub(super) fn chunks(&mut self, slots: usize) -> impl Iterator<Item = VolumesChunk<'_, R, D>> {
        let mut kinds = self.kinds.chunks(slots);
        let mut balls = self.balls.chunks_mut(slots);
        let mut are_stale = self.are_stale.chunks_mut(slots);
        let mut near = self.near.chunks(slots);
        let (skin, shortfall) = (self.skin, self.shortfall);
        std::iter::repeat_with(move || VolumesChunk {
            kinds: kinds.next().unwrap_or_default(),
            balls: balls.next().unwrap_or_default(),
            are_stale: are_stale.next().unwrap_or_default(),
            near: near.next().unwrap_or_default(),
            skin,
            shortfall,
        })
    }

    /// Whether two volumes may meet, each loosened by half of `slack`, if neither has half axes; `None` if one may have some.
    #[inline(always)]
    pub(super) fn meet_without_half_axes(&self, [a, b]: [u32; 2], slack: R) -> Option<bool> {
        // A box is a ball that meets all. The first slot is the smaller one.
        let (i, j) = (a as usize, b as usize);
        let have_none = i >= self.half_axes.len();
        have_none.then(|| self.balls[i].meets(&self.balls[j], slack))
    }

    /// The same for any two volumes.
    #[inline(never)]
    pub(super) fn meet(&self, [a, b]: [u32; 2], slack: R) -> bool {
        self.get(a).meets(self.get(b), slack)
    }
}

/// The noted value, unless more is wanted.
fn at_least<R: Real>(noted: R, wanted: R) -> R {
    match wanted > noted {
        true => max(wanted, noted * R::from_f64(GROWTH)),
        false => noted,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn volumes_in_use() -> Volumes<f32, 2> {
        Volumes {
            are_used: true,
            ..Volumes::default()
        }
    }

    /// At which of these margins and reaches, noted one after the other, all volumes become stale.
    fn grown_at(extents: impl IntoIterator<Item = [f32; 2]>) -> Vec<usize> {
        let mut volumes = volumes_in_use();
        let extents = extents.into_iter().enumerate();
        let grown = extents.filter(|&(_, [margin, reach])| volumes.note_extents(margin, reach));
        grown.map(|(i, _)| i).collect()
    }

    #[test]
    fn extents_grow_only_beyond_all_earlier_ones() {
        // Each of the two has the larger margin or the larger reach.
        let [first, second] = [[0.25, 2.0], [0.5, 1.0]];
        assert_eq!(grown_at([first, second].repeat(3)), [0, 1]);
        let [nan, infinite] = [[f32::NAN; 2], [f32::INFINITY; 2]];
        assert_eq!(grown_at([nan, infinite, first, infinite, nan, second]), [1]);
    }

    #[test]
    fn extents_that_grow_a_little_each_time_seldom_count_as_grown() {
        let growing = (0..64).map(|i| [1.0 + i as f32 / 16.0; 2]);
        // From 0, and beyond 1, 2 and 4.
        assert_eq!(grown_at(growing), [0, 1, 17, 49]);
    }

    #[test]
    fn a_ball_stays_within_its_skin_unless_its_radius_changes() {
        let mut volumes = volumes_in_use();
        volumes.make_room(1);
        volumes.note_extents(1.0, 0.0);
        // The skin is a sixteenth.
        let balls = [(0.0, 0.5), (0.06, 0.5), (0.0, 0.51), (0.07, 0.51)];
        let balls = balls.map(|(x, radius)| Volume::new(VolumeKind::Ball, [x, 0.0], radius, &[]));
        let replaced = balls.map(|ball| volumes.set(0, &ball));
        assert_eq!(replaced, [true, false, true, true]);
        assert_eq!(*volumes.get(0).ball, balls[3].ball);
    }
}
