//! The bounding volumes of all slots, if volumes are in use.
//!
//! A volume has a margin, as a box has, and a smaller one. While the collider's volume differs from it by less, and the box is not renewed,
//! the volume stays, and the proxy is *slow* until its box is renewed. So proxies that hardly move are not compared again. The volume of a
//! slow proxy is loosened by the margin; all others are exact.
//!
//! A ball takes a kind, a centre and a radius. Half axes are kept only up to the highest slot that has ever had some.

mod chunk;

use super::odometer::{Due, Odometer};
use crate::aabb::max;
use crate::real::Real;
use crate::tuning::prices::BEYOND_BALLS;
use crate::volume::{Ball, Volume, VolumeKind, VolumeRef};
use chunk::volume_of;
pub(crate) use chunk::{VolumeUpdate, VolumesChunk};

/// Pairs per slot whose boxes overlap and whose volumes do not. From this many on, in worlds of capsules, a pair is asked again only once
/// both may have moved far enough. If larger: bundles of capsules are asked in each update. If smaller: counting moves takes longer than
/// asking.
const DUES_FROM: usize = 2;

/// The margin of a volume, in margins of a box. If larger: more pairs begin that are near and do not touch. If smaller: more proxies that
/// come to rest are compared in each update. Events depend on it.
pub(crate) const VOLUME_MARGIN: f64 = 0.0625;

/// The least factor by which a margin or a reach grows. All volumes are read again when one does. If larger: more pairs begin that are near
/// and do not touch. If smaller: volumes are read more often where a parameter grows in every frame. Events depend on it.
const GROWTH: f64 = 2.0;

/// Volumes by slot; none unless they are in use.
#[derive(Clone, Debug, Default)]
pub(crate) struct Volumes<R, const D: usize> {
    are_used: bool,
    kinds: Vec<VolumeKind>,
    balls: Vec<Ball<R, D>>,
    /// Of the first slots; no volume of a higher slot has any.
    half_axes: Vec<[[R; D]; D]>,
    /// Whether the collider may be elsewhere by up to the margin.
    are_slow: Vec<bool>,
    /// How far each volume has moved since the last full search; empty if that is not counted.
    odometers: Vec<Odometer>,
    /// Updates since the last full search.
    moves: u32,
    /// The largest margin so far.
    margin: R,
    /// The largest distance so far by which all shapes are extended. Volumes are read with it even while the parameters ask for less, so that
    /// parameters may alternate, and any two volumes are right for the larger ones.
    reach: R,
    /// The distance by which the boxes that a program passes are extended less.
    pub(crate) shortfall: R,
}

/// The serialized form of volumes.
#[cfg(feature = "serde-serialize")]
#[derive(serde::Serialize, serde::Deserialize)]
pub(crate) struct VolumesSnapshot<R> {
    /// `None` if it is infinite.
    margin: Option<R>,
    /// `None` if it is not finite.
    reach: Option<R>,
    /// For each slot the kind, whether it is slow, and the numbers; empty if volumes are not in use.
    by_slot: Vec<(VolumeKind, bool, Vec<R>)>,
}

impl<R: Real, const D: usize> Volumes<R, D> {
    pub(super) fn new(are_used: bool) -> Self {
        Self {
            are_used,
            ..Self::default()
        }
    }

    /// Notes the margin of boxes, and how far all shapes are extended. Returns whether either [has
    /// grown](Self::have_longer_extents); then the caller must [reset](super::Proxies::reset_volume) all volumes.
    pub(crate) fn note_extents(&mut self, margin: R, reach: R) -> bool {
        let have_grown = self.have_longer_extents(margin, reach);
        if have_grown {
            self.margin = at_least(self.margin, margin * R::from_f64(VOLUME_MARGIN));
            self.reach = self.reach_for(reach);
            self.odometers.fill(Odometer::LOST);
        }
        have_grown
    }

    /// Whether volumes are in use, and the margin or the reach is larger than the noted one.
    pub(crate) fn have_longer_extents(&self, margin: R, reach: R) -> bool {
        let margin = margin * R::from_f64(VOLUME_MARGIN);
        self.are_used && (margin > self.margin || reach > self.reach)
    }

    /// The distance by which shapes are extended where volumes are read, if the parameters ask for this one. A NaN counts as 0.
    pub(crate) fn reach_for(&self, reach: R) -> R {
        at_least(self.reach, reach)
    }

    pub(crate) fn are_used(&self) -> bool {
        self.are_used
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
            self.are_slow.resize(slots, false);
            if self.have_odometers() {
                self.odometers.resize(slots, Odometer::default());
            }
        }
    }

    /// Whether odometers count, so that candidates have dues.
    pub(super) fn have_odometers(&self) -> bool {
        !self.odometers.is_empty()
    }

    /// Counts an update.
    pub(super) fn note_moves(&mut self) {
        self.moves = self.moves.saturating_add(1);
    }

    /// Sets all odometers to 0, when no candidate has a due. From now on they count if enough pairs are `near` and not held, and most
    /// volumes are capsules: the test of others is too fast for odometers to pay.
    pub(super) fn reset_odometers(&mut self, near: usize) {
        let slots = self.kinds.len();
        let is_capsule = |kind: &&VolumeKind| **kind == VolumeKind::Capsule;
        let is_worth_it =
            || near > DUES_FROM * slots && 2 * self.kinds.iter().filter(is_capsule).count() > slots;
        // Debug builds have them in any case, so that tests need not have thousands of colliders.
        self.odometers.clear();
        if self.are_used && (cfg!(debug_assertions) || is_worth_it()) {
            self.odometers.resize(slots, Odometer::default());
            self.moves = 0;
        }
    }

    /// The volume of a slot, for which there must be room.
    #[inline(always)]
    pub(crate) fn get(&self, slot: u32) -> VolumeRef<'_, R, D> {
        volume_of(&self.kinds, &self.balls, &self.half_axes, slot as usize)
    }

    /// Sets the volume of a slot, for which there must be room. It stays if it differs by less than the margin and the box is not
    /// renewed. Returns whether pairs of the slot may begin or end.
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
                // Twice as many, but no more than kinds have room for, which grow in the same way.
                let room = (2 * room).min(self.kinds.capacity()).max(index + 1);
                self.half_axes.reserve_exact(room - self.half_axes.len());
            }
            self.half_axes
                .resize(index + 1, Volume::<R, D>::BOX.half_axes);
        }
        let is_replaced = is_renewed | is_of_another_kind;
        let update = self.all().set(index, volume, is_replaced);
        if is_of_another_kind && self.have_odometers() {
            self.odometers[index] = Odometer::LOST;
        }
        is_of_another_kind || update.is_some_and(VolumeUpdate::concerns_pairs)
    }

    /// The serialized form of all volumes.
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

    /// Restores the volumes of this number of slots.
    ///
    /// # Errors
    /// A message, if no volumes have this serialized form.
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
        let are_distances = self.margin >= R::ZERO && self.reach >= R::ZERO;
        if !are_distances {
            return Err("snapshot: the margin or the reach of volumes is not a distance");
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

    /// All volumes, to be written in place.
    #[inline(always)]
    pub(super) fn all(&mut self) -> VolumesChunk<'_, R, D> {
        VolumesChunk {
            kinds: &self.kinds,
            balls: &mut self.balls,
            half_axes: &mut self.half_axes,
            are_slow: &mut self.are_slow,
            odometers: &mut self.odometers,
            margin: self.margin,
            shortfall: self.shortfall,
        }
    }

    /// Chunks of this many slots, followed by empty ones without end. If volumes are not in use, all are empty.
    pub(super) fn chunks(&mut self, slots: usize) -> impl Iterator<Item = VolumesChunk<'_, R, D>> {
        let mut kinds = self.kinds.chunks(slots);
        let mut balls = self.balls.chunks_mut(slots);
        let mut half_axes = self.half_axes.chunks_mut(slots);
        let mut are_slow = self.are_slow.chunks_mut(slots);
        let mut odometers = self.odometers.chunks_mut(slots);
        let (margin, shortfall) = (self.margin, self.shortfall);
        std::iter::repeat_with(move || VolumesChunk {
            kinds: kinds.next().unwrap_or_default(),
            balls: balls.next().unwrap_or_default(),
            half_axes: half_axes.next().unwrap_or_default(),
            are_slow: are_slow.next().unwrap_or_default(),
            odometers: odometers.next().unwrap_or_default(),
            margin,
            shortfall,
        })
    }

    /// Whether two volumes may meet, each loosened by half of `slack`, and by the margin if it is slow.
    #[inline(always)]
    pub(super) fn meet(&self, pair: [u32; 2], slack: R) -> bool {
        match self.meet_as_balls(pair, slack) {
            Some(meet) => meet,
            None => self.meet_beyond_balls(pair, slack),
        }
    }

    /// The same for two balls, if most proxies are balls.
    #[inline(always)]
    pub(super) fn meet_as_balls(&self, [a, b]: [u32; 2], slack: R) -> Option<bool> {
        // A box is a ball that meets all. The first slot is the smaller one.
        let (i, j) = (a as usize, b as usize);
        let are_balls = i >= self.half_axes.len();
        are_balls.then(|| self.balls[i].meets(&self.balls[j], self.loosened([a, b], slack)))
    }

    /// Whether two volumes that were apart may meet now. If they have a due, they are tested only once it is reached, and the due is set.
    #[inline(always)]
    pub(super) fn have_met(&self, pair: [u32; 2], due: Option<&mut Due>) -> bool {
        match self.meet_as_balls(pair, R::ZERO) {
            Some(meet) => meet,
            None => self.have_met_beyond_balls(pair, due),
        }
    }

    /// The same for two volumes that are not [both balls](Self::meet_as_balls).
    #[inline(always)]
    pub(super) fn have_met_beyond_balls(&self, pair: [u32; 2], due: Option<&mut Due>) -> bool {
        match due {
            None => self.meet_beyond_balls(pair, R::ZERO),
            Some(due) => {
                due.is_reached(self.odometers_of(pair)) && self.have_met_when_due(pair, due)
            }
        }
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

    /// The sum of the slack and of the margins of slow proxies.
    #[inline(always)]
    fn loosened(&self, pair: [u32; 2], slack: R) -> R {
        let [a, b] = pair.map(|slot| match self.are_slow[slot as usize] {
            true => self.margin,
            false => R::ZERO,
        });
        slack + (a + b)
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

    const SLOTS: [u32; 2] = [0, 1];

    fn capsule(x: f32, half: f32) -> Volume<f32, 2> {
        Volume::new(VolumeKind::Capsule, [x, 0.0], 0.1, &[[half, 0.0]])
    }

    /// Two capsules on one line with a gap of 0.2, and the due of the pair after a test.
    fn tested() -> (Volumes<f32, 2>, Due) {
        let mut volumes = Volumes::new(true);
        volumes.make_room(2);
        volumes.note_extents(1.0, 0.0);
        volumes.set(0, &capsule(0.0, 1.0), true);
        volumes.set(1, &capsule(2.4, 1.0), true);
        volumes.reset_odometers(0);
        volumes.note_moves();
        let mut due = Due::default();
        assert!(!volumes.have_met(SLOTS, Some(&mut due)));
        assert!(!due.is_reached(volumes.odometers_of(SLOTS)));
        (volumes, due)
    }

    #[test]
    fn a_volume_of_another_kind_for_a_while_is_tested() {
        let (mut volumes, _) = tested();
        volumes.set(
            0,
            &Volume::new(VolumeKind::Ball, [0.25, 0.0], 0.1, &[]),
            true,
        );
        let mut due = Due::default();
        assert!(!volumes.have_met(SLOTS, Some(&mut due)));
        // Its half axes are the former ones.
        volumes.set(0, &capsule(0.25, 1.0), true);
        assert!(volumes.have_met(SLOTS, Some(&mut due)));
    }

    #[test]
    fn a_volume_that_becomes_slow_is_tested() {
        let (mut volumes, mut due) = tested();
        let margin = VOLUME_MARGIN as f32;
        volumes.set(0, &capsule(0.2 - 0.75 * margin, 1.0), true);
        volumes.set(1, &capsule(2.4, 1.0), true);
        assert!(!volumes.have_met(SLOTS, Some(&mut due)) && !due.is_hopeless());
        // It has hardly moved, so it stays, and becomes slow.
        volumes.set(1, &capsule(2.4 + 0.01 * margin, 1.0), false);
        assert!(volumes.have_met(SLOTS, Some(&mut due)));
    }
}
