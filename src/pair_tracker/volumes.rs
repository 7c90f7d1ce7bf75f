//! The bounding volumes of all slots, if pairs are told apart by them.
//!
//! As a box has a margin, so has a volume, of a part of it: while the collider's own differs by less, and the box is not renewed, it
//! stays, and the proxy is *slow* until its box is renewed. So what hardly moves is not compared again. The volumes of what is slow are
//! loosened by that margin; others are as of this update.
//!
//! A ball takes a kind, a centre and a radius; half axes are kept only up to the highest slot that has had some.

use super::odometer::{Due, Odometer};
use crate::aabb::Aabb;
use crate::real::Real;
use crate::tuning::prices::BEYOND_BALLS;
use crate::tuning::update::DUES_FROM;
use crate::volume::{Ball, Volume, VolumeKind, VolumeRef};

/// The margin of a volume, in margins of a box. With a wider one, more pairs begin that are near and do not touch; with a narrower
/// one, more of what settles is compared in each update. Events depend on it.
pub(crate) const VOLUME_MARGIN: f64 = 0.0625;

/// Volumes by slot; none unless they are in use.
#[derive(Clone, Debug, Default)]
pub(crate) struct Volumes<R, const D: usize> {
    are_used: bool,
    kinds: Vec<VolumeKind>,
    balls: Vec<Ball<R, D>>,
    /// Of the first slots; behind them, no volume has any.
    half_axes: Vec<[[R; D]; D]>,
    /// Whether the collider may be elsewhere, by less than the margin.
    are_slow: Vec<bool>,
    /// Whether odometers go on.
    have_odometers: bool,
    /// How far each has moved since the last full search, if they go on.
    odometers: Vec<Odometer>,
    /// In how many updates.
    moves: u32,
    margin: R,
    /// By how much all shapes were extended when volumes were last read.
    reach: R,
}

/// Volumes as they are written.
#[cfg(feature = "serde-serialize")]
#[derive(serde::Serialize, serde::Deserialize)]
pub(crate) struct VolumesSnapshot<R> {
    /// `None` if it is infinite.
    margin: Option<R>,
    /// `None` if it is not finite.
    reach: Option<R>,
    /// The kind of each, whether it is slow, and its numbers; none if volumes are not in use.
    by_slot: Vec<(VolumeKind, bool, Vec<R>)>,
}

/// What happens to the volume of a proxy when its collider has another one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum VolumeUpdate {
    /// It stays, and so do its pairs.
    Keep,
    /// It stays, loosened by the margin from now on: its pairs must be compared.
    Loosen,
    /// The new volume takes its place: its pairs must be compared.
    Renew,
    /// Nothing: the volumes are of different kinds, or the box alone does not determine the new one.
    Recheck,
}

/// The volumes of a chunk of slots, whose kinds stay as they are.
pub(crate) struct VolumesChunk<'a, R, const D: usize> {
    kinds: &'a [VolumeKind],
    balls: &'a mut [Ball<R, D>],
    half_axes: &'a mut [[[R; D]; D]],
    are_slow: &'a mut [bool],
    /// Empty if they stand still.
    odometers: &'a mut [Odometer],
    margin: R,
}

impl<R: Real, const D: usize> Volumes<R, D> {
    pub(super) fn new(are_used: bool) -> Self {
        Self {
            are_used,
            ..Self::default()
        }
    }

    /// Takes note of the margin that boxes have from now on, and of by how much all shapes are extended. Returns whether either is
    /// another one than before, so that all volumes have to be [reset](super::Proxies::reset_volume).
    pub(crate) fn note_extents(&mut self, margin: R, reach: R) -> bool {
        let margin = margin * R::from_f64(VOLUME_MARGIN);
        let have_changed = self.are_used && (self.margin, self.reach) != (margin, reach);
        if have_changed {
            (self.margin, self.reach) = (margin, reach);
            self.odometers.fill(Odometer::LOST);
        }
        have_changed
    }

    pub(crate) fn are_used(&self) -> bool {
        self.are_used
    }

    /// A price of working with boxes and volumes, given that with boxes and balls alone.
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
            self.are_slow.resize(slots, false);
            self.odometers.resize(slots, Odometer::default());
        }
    }

    /// Whether candidates have dues.
    pub(super) fn have_odometers(&self) -> bool {
        self.have_odometers
    }

    /// Takes note of an update.
    pub(super) fn note_moves(&mut self) {
        self.moves = self.moves.saturating_add(1);
    }

    /// Sets all odometers to 0, once no candidate has a due. From now on they go on if so many pairs are near each other and apart, and
    /// most volumes are capsules: others are asked too fast for odometers to pay.
    pub(super) fn reset_odometers(&mut self, near: usize) {
        let slots = self.kinds.len();
        let is_capsule = |kind: &&VolumeKind| **kind == VolumeKind::Capsule;
        let is_worth_it =
            || near > DUES_FROM * slots && 2 * self.kinds.iter().filter(is_capsule).count() > slots;
        // Debug builds have them anyway, so that tests need not be of thousands.
        self.have_odometers = self.are_used && (cfg!(debug_assertions) || is_worth_it());
        if self.have_odometers {
            self.odometers.fill(Odometer::default());
            self.moves = 0;
        }
    }

    /// The volume of a slot, for which there must be room.
    #[inline(always)]
    pub(crate) fn get(&self, slot: u32) -> VolumeRef<'_, R, D> {
        volume_of(&self.kinds, &self.balls, &self.half_axes, slot as usize)
    }

    /// Sets the volume of a slot, for which there must be room, unless it is within the margin of what it is, and the box is not
    /// renewed. Returns whether it is another one than before.
    pub(super) fn set(&mut self, slot: u32, volume: &Volume<R, D>, is_renewed: bool) -> bool {
        if !self.are_used {
            return false;
        }
        let (index, kind) = (slot as usize, volume.kind);
        let is_of_another_kind = kind != self.kinds[index];
        self.kinds[index] = kind;
        if kind.axes::<D>() > 0 && index >= self.half_axes.len() {
            let room = self.half_axes.capacity();
            if index >= room {
                // Twice as many, but no more than kinds have room for, which grows in the same way.
                let room = (2 * room).min(self.kinds.capacity()).max(index + 1);
                self.half_axes.reserve_exact(room - self.half_axes.len());
            }
            self.half_axes
                .resize(index + 1, Volume::<R, D>::BOX.half_axes);
        }
        let update = self
            .all()
            .set(index, volume, is_renewed | is_of_another_kind);
        if is_of_another_kind {
            self.odometers[index] = Odometer::LOST;
        }
        update != VolumeUpdate::Keep || is_of_another_kind
    }

    /// All volumes, as they are written.
    #[cfg(feature = "serde-serialize")]
    pub(super) fn snapshot(&self) -> VolumesSnapshot<R> {
        let slots = 0..self.kinds.len() as u32;
        let volumes = slots.map(|slot| (self.get(slot), self.are_slow[slot as usize]));
        VolumesSnapshot {
            // Some formats have no infinity.
            margin: self.margin.is_finite().then_some(self.margin),
            reach: self.reach.is_finite().then_some(self.reach),
            by_slot: volumes
                .map(|(volume, is_slow)| (volume.kind, is_slow, volume.numbers()))
                .collect(),
        }
    }

    /// The volumes of this number of slots.
    ///
    /// # Errors
    /// What is wrong, if no volumes can have been written like this.
    #[cfg(feature = "serde-serialize")]
    pub(super) fn restore(
        &mut self,
        snapshot: VolumesSnapshot<R>,
        slots: usize,
    ) -> Result<(), &'static str> {
        let VolumesSnapshot {
            margin,
            reach,
            by_slot,
        } = snapshot;
        if by_slot.len() != if self.are_used { slots } else { 0 } {
            return Err("snapshot: there is not one volume for each slot");
        }
        self.margin = margin.unwrap_or(R::INFINITY);
        self.reach = reach.unwrap_or(R::INFINITY);
        let is_distance = self.margin >= R::ZERO;
        if !is_distance {
            return Err("snapshot: the margin of volumes is not a distance");
        }
        self.make_room(by_slot.len());
        for (slot, (kind, is_slow, numbers)) in (0..).zip(by_slot) {
            let volume = Volume::of_numbers(kind, &numbers);
            self.set(
                slot,
                &volume.ok_or("snapshot: a volume has other numbers than its kind can have")?,
                true,
            );
            self.are_slow[slot as usize] = is_slow;
        }
        Ok(())
    }

    /// All volumes, to move them in place.
    #[inline(always)]
    pub(super) fn all(&mut self) -> VolumesChunk<'_, R, D> {
        let have_odometers = self.have_odometers();
        VolumesChunk {
            kinds: &self.kinds,
            balls: &mut self.balls,
            half_axes: &mut self.half_axes,
            are_slow: &mut self.are_slow,
            odometers: match have_odometers {
                true => &mut self.odometers,
                false => &mut [],
            },
            margin: self.margin,
        }
    }

    /// Chunks of this many slots, and then empty ones without end: if volumes are not in use, there are no others.
    pub(super) fn chunks(&mut self, slots: usize) -> impl Iterator<Item = VolumesChunk<'_, R, D>> {
        let odometers = match self.have_odometers() {
            true => &mut self.odometers[..],
            false => &mut [],
        };
        let mut kinds = self.kinds.chunks(slots);
        let mut balls = self.balls.chunks_mut(slots);
        let mut half_axes = self.half_axes.chunks_mut(slots);
        let mut are_slow = self.are_slow.chunks_mut(slots);
        let mut odometers = odometers.chunks_mut(slots);
        let margin = self.margin;
        std::iter::repeat_with(move || VolumesChunk {
            kinds: kinds.next().unwrap_or_default(),
            balls: balls.next().unwrap_or_default(),
            half_axes: half_axes.next().unwrap_or_default(),
            are_slow: are_slow.next().unwrap_or_default(),
            odometers: odometers.next().unwrap_or_default(),
            margin,
        })
    }

    /// Whether two proxies may meet, by their volumes, loosened by half of `slack` each, and by their margins.
    #[inline(always)]
    pub(super) fn meet(&self, pair: [u32; 2], slack: R) -> bool {
        match self.meet_as_balls(pair, slack) {
            Some(meet) => meet,
            None => self.meet_beyond_balls(pair, slack),
        }
    }

    /// The same if both are balls, and so are most proxies.
    #[inline(always)]
    pub(super) fn meet_as_balls(&self, [a, b]: [u32; 2], slack: R) -> Option<bool> {
        // A box, too, is a ball that meets all. The first slot is the smaller one.
        let (i, j) = (a as usize, b as usize);
        let are_balls = i >= self.half_axes.len();
        are_balls.then(|| self.balls[i].meets(&self.balls[j], self.loosened([a, b], slack)))
    }

    /// Whether two proxies that were apart may meet now. They are asked only if that is due.
    #[inline(always)]
    pub(super) fn have_met(&self, pair: [u32; 2], due: &mut Due) -> bool {
        due.is_reached(self.odometers_of(pair)) && self.have_met_when_due(pair, due)
    }

    #[inline(never)]
    fn have_met_when_due(&self, pair: [u32; 2], due: &mut Due) -> bool {
        let loosened = self.loosened(pair, R::ZERO);
        let [a, b] = pair.map(|slot| self.get(slot));
        let meet = a.meets(b, loosened);
        if !meet && !due.is_hopeless() {
            *due = Due::of_room(self.odometers_of(pair), a.room(b, loosened), self.moves);
        }
        meet
    }

    #[inline(always)]
    fn odometers_of(&self, pair: [u32; 2]) -> [Odometer; 2] {
        pair.map(|slot| self.odometers[slot as usize])
    }

    #[inline(never)]
    fn meet_beyond_balls(&self, [a, b]: [u32; 2], slack: R) -> bool {
        self.get(a).meets(self.get(b), self.loosened([a, b], slack))
    }

    /// A slack, and the margins of those that are slow.
    #[inline(always)]
    fn loosened(&self, pair: [u32; 2], slack: R) -> R {
        let [a, b] = pair.map(|slot| match self.are_slow[slot as usize] {
            true => self.margin,
            false => R::ZERO,
        });
        slack + (a + b)
    }
}

/// The volume of the slot `i` of a run of slots.
#[inline(always)]
fn volume_of<'a, R: Real, const D: usize>(
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

impl<R: Real, const D: usize> VolumesChunk<'_, R, D> {
    #[inline(always)]
    pub(super) fn are_used(&self) -> bool {
        !self.kinds.is_empty()
    }

    /// The volume of the slot `i` of the chunk in this box, if no more than the box is needed to tell.
    #[inline(always)]
    pub(super) fn by_box(&self, i: usize, aabb: &Aabb<R, D>) -> Option<Volume<R, D>> {
        match self.kinds.get(i)? {
            VolumeKind::Part => Some(Volume::PART),
            VolumeKind::Ball => Some(Volume {
                kind: VolumeKind::Ball,
                ball: self.balls[i].in_box(aabb),
                ..Volume::BOX
            }),
            _ => None,
        }
    }

    /// Moves the volume of the slot `i` of the chunk, or keeps it if it has hardly moved and its box is not renewed.
    #[inline(always)]
    pub(crate) fn set(
        &mut self,
        i: usize,
        volume: &Volume<R, D>,
        is_renewed: bool,
    ) -> VolumeUpdate {
        let kind = volume.kind;
        if kind != self.kinds[i] {
            return VolumeUpdate::Recheck;
        }
        if matches!(kind, VolumeKind::Box | VolumeKind::Part) && !is_renewed {
            return VolumeUpdate::Keep;
        }
        let former = volume_of(self.kinds, self.balls, self.half_axes, i);
        let change = former.change_to(volume.as_ref());
        let update = self.update_of(i, change, is_renewed);
        if update == VolumeUpdate::Renew {
            if kind.axes::<D>() > 0 {
                self.half_axes[i] = volume.half_axes;
            }
            self.balls[i] = volume.ball;
        }
        update
    }

    /// Does the same for a ball in this box, and for a volume that no box changes.
    #[inline(always)]
    pub(crate) fn set_by_box(
        &mut self,
        i: usize,
        aabb: &Aabb<R, D>,
        is_renewed: bool,
    ) -> VolumeUpdate {
        match self.kinds[i] {
            VolumeKind::Part => VolumeUpdate::Keep,
            VolumeKind::Ball => {
                let ball = self.balls[i].in_box(aabb);
                let change = self.balls[i].change_to(&ball);
                let update = self.update_of(i, change, is_renewed);
                if update == VolumeUpdate::Renew {
                    self.balls[i] = ball;
                }
                update
            }
            _ => VolumeUpdate::Recheck,
        }
    }

    /// Decides between keeping the volume of the slot `i` and renewing it, and notes what that does to its margin.
    #[inline(always)]
    fn update_of(&mut self, i: usize, change: R, is_renewed: bool) -> VolumeUpdate {
        if change <= self.margin && !is_renewed {
            let is_slow = self.are_slow[i] | (change > R::ZERO);
            let is_slow_now = is_slow & !std::mem::replace(&mut self.are_slow[i], is_slow);
            if is_slow_now {
                self.advance(i, self.margin);
                return VolumeUpdate::Loosen;
            }
            return VolumeUpdate::Keep;
        }
        self.advance(i, change);
        if is_renewed & self.are_slow[i] {
            // It is no longer loosened.
            self.advance(i, self.margin);
        }
        self.are_slow[i] &= !is_renewed;
        VolumeUpdate::Renew
    }

    /// Lets the odometer of the slot `i` go on, if it does not stand still.
    #[inline(always)]
    fn advance(&mut self, i: usize, by: R) {
        if let Some(odometer) = self.odometers.get_mut(i) {
            odometer.advance(by);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SLOTS: [u32; 2] = [0, 1];

    fn capsule(x: f32, half: f32) -> Volume<f32, 2> {
        Volume::new(VolumeKind::Capsule, [x, 0.0], 0.1, &[[half, 0.0]])
    }

    /// Two capsules on one line with a gap of 0.2, and the due of the pair once it was asked.
    fn asked() -> (Volumes<f32, 2>, Due) {
        let mut volumes = Volumes::new(true);
        volumes.make_room(2);
        volumes.note_extents(1.0, 0.0);
        volumes.set(0, &capsule(0.0, 1.0), true);
        volumes.set(1, &capsule(2.4, 1.0), true);
        volumes.reset_odometers(0);
        volumes.note_moves();
        let mut due = Due::default();
        assert!(!volumes.have_met(SLOTS, &mut due));
        assert!(!due.is_reached(volumes.odometers_of(SLOTS)));
        (volumes, due)
    }

    #[test]
    fn what_was_of_another_kind_for_a_while_is_asked() {
        let (mut volumes, _) = asked();
        volumes.set(
            0,
            &Volume::new(VolumeKind::Ball, [0.25, 0.0], 0.1, &[]),
            true,
        );
        let mut due = Due::default();
        assert!(!volumes.have_met(SLOTS, &mut due));
        // Its half axes are those that it had.
        volumes.set(0, &capsule(0.25, 1.0), true);
        assert!(volumes.have_met(SLOTS, &mut due));
    }

    #[test]
    fn what_is_loosened_because_it_is_slow_is_asked() {
        let (mut volumes, mut due) = asked();
        let margin = VOLUME_MARGIN as f32;
        volumes.set(0, &capsule(0.2 - 0.75 * margin, 1.0), true);
        volumes.set(1, &capsule(2.4, 1.0), true);
        assert!(!volumes.have_met(SLOTS, &mut due) && !due.is_hopeless());
        // It stays, for it has hardly moved, and counts as elsewhere.
        volumes.set(1, &capsule(2.4 + 0.01 * margin, 1.0), false);
        assert!(volumes.have_met(SLOTS, &mut due));
    }
}
