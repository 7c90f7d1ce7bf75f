//! The bounding volumes of all slots, if pairs are told apart by them.
//!
//! A ball takes a kind, a centre and a radius; half axes are kept only up to the highest slot that has had some.

use crate::volume::{Ball, Volume, VolumeKind};
use crate::{Aabb, Real};

/// Volumes by slot; none unless they are in use.
#[derive(Clone, Debug)]
pub(crate) struct Volumes<R, const D: usize> {
    are_used: bool,
    kinds: Vec<VolumeKind>,
    balls: Vec<Ball<R, D>>,
    /// Of the first slots; behind them, no volume has any.
    half_axes: Vec<[[R; D]; D]>,
}

/// The volumes of a run of slots, whose kinds stay as they are.
pub(crate) struct VolumesPart<'a, R, const D: usize> {
    kinds: &'a [VolumeKind],
    balls: &'a mut [Ball<R, D>],
    half_axes: &'a mut [[[R; D]; D]],
}

impl<R: Real, const D: usize> Volumes<R, D> {
    pub(super) fn new(are_used: bool) -> Self {
        Self {
            are_used,
            kinds: Vec::new(),
            balls: Vec::new(),
            half_axes: Vec::new(),
        }
    }

    pub(crate) fn are_used(&self) -> bool {
        self.are_used
    }

    pub(super) fn make_room(&mut self, slots: usize) {
        if self.are_used && slots > self.kinds.len() {
            self.kinds.resize(slots, VolumeKind::Box);
            self.balls.resize(slots, Volume::BOX.ball);
        }
    }

    /// The volume of a slot; one that meets all if there is none.
    #[inline(always)]
    pub(crate) fn get(&self, slot: u32) -> Volume<R, D> {
        let index = slot as usize;
        let (Some(&kind), Some(&ball)) = (self.kinds.get(index), self.balls.get(index)) else {
            return Volume::BOX;
        };
        Volume {
            kind,
            ball,
            half_axes: match kind.axes::<D>() {
                0 => Volume::<R, D>::BOX.half_axes,
                _ => self.half_axes[index],
            },
        }
    }

    /// Sets the volume of a slot, for which there must be room. Returns whether it is another one than before.
    pub(super) fn set(&mut self, slot: u32, volume: &Volume<R, D>) -> bool {
        if !self.are_used {
            return false;
        }
        let index = slot as usize;
        let has_changed = self.get(slot) != *volume;
        let Volume {
            kind,
            ball,
            half_axes,
        } = *volume;
        self.kinds[index] = kind;
        self.balls[index] = ball;
        if kind.axes::<D>() > 0 {
            if index >= self.half_axes.len() {
                self.half_axes
                    .resize(index + 1, Volume::<R, D>::BOX.half_axes);
            }
            self.half_axes[index] = half_axes;
        }
        has_changed
    }

    /// By slot, the kinds and the numbers.
    #[cfg(feature = "serde-serialize")]
    pub(super) fn snapshot(&self) -> Vec<(VolumeKind, Vec<R>)> {
        let slots = 0..self.kinds.len() as u32;
        slots
            .map(|slot| {
                let volume = self.get(slot);
                (volume.kind, volume.numbers())
            })
            .collect()
    }

    /// The volumes of this number of slots.
    ///
    /// # Errors
    /// What is wrong, if no volumes can have been written like this.
    #[cfg(feature = "serde-serialize")]
    pub(super) fn restore(
        &mut self,
        volumes: Vec<(VolumeKind, Vec<R>)>,
        slots: usize,
    ) -> Result<(), &'static str> {
        if volumes.len() != if self.are_used { slots } else { 0 } {
            return Err("snapshot: there is not one volume for each slot");
        }
        self.make_room(volumes.len());
        for (slot, (kind, numbers)) in (0..).zip(volumes) {
            let volume = Volume::of_numbers(kind, &numbers);
            self.set(slot, &volume.ok_or("snapshot: a volume lacks a number")?);
        }
        Ok(())
    }

    /// All volumes, to move them in place.
    pub(super) fn part(&mut self) -> VolumesPart<'_, R, D> {
        VolumesPart {
            kinds: &self.kinds,
            balls: &mut self.balls,
            half_axes: &mut self.half_axes,
        }
    }

    /// Whether two proxies may meet, by their volumes, loosened by half of `slack` each.
    #[inline(always)]
    pub(super) fn meet(&self, pair: [u32; 2], slack: R) -> bool {
        let [i, j] = pair.map(|slot| slot as usize);
        if self.kinds[i] == VolumeKind::Ball && self.kinds[j] == VolumeKind::Ball {
            return self.balls[i].meets(&self.balls[j], slack);
        }
        self.meet_beyond_balls(pair, slack)
    }

    #[inline(never)]
    fn meet_beyond_balls(&self, [a, b]: [u32; 2], slack: R) -> bool {
        self.get(a).meets(&self.get(b), slack)
    }
}

impl<'a, R: Real, const D: usize> VolumesPart<'a, R, D> {
    /// Splits off the first slots, at most this many.
    pub(crate) fn split_front(&mut self, count: usize) -> Self {
        let Self {
            kinds,
            balls,
            half_axes,
        } = self;
        let (front_kinds, rest) = kinds.split_at(count.min(kinds.len()));
        *kinds = rest;
        Self {
            kinds: front_kinds,
            balls: split_front(balls, count),
            half_axes: split_front(half_axes, count),
        }
    }

    /// The kind of the volume of the slot `i` of the part.
    #[inline(always)]
    pub(crate) fn kind(&self, i: usize) -> VolumeKind {
        self.kinds[i]
    }

    /// Moves the volume of the slot `i` of the part, whose kind must be the same as before. Returns whether it is another one.
    #[inline(always)]
    pub(crate) fn set(&mut self, i: usize, volume: &Volume<R, D>) -> bool {
        debug_assert_eq!(volume.kind, self.kinds[i]);
        let mut has_changed = self.set_ball(i, volume.ball);
        if volume.kind.axes::<D>() > 0 {
            let half_axes = volume.half_axes;
            has_changed |= std::mem::replace(&mut self.half_axes[i], half_axes) != half_axes;
        }
        has_changed
    }

    /// Moves the ball of the slot `i` of the part, which must be one, into a box. Returns whether it is another one.
    #[inline(always)]
    pub(crate) fn set_ball_in(&mut self, i: usize, aabb: &Aabb<R, D>) -> bool {
        self.set_ball(i, self.balls[i].in_box(aabb))
    }

    #[inline(always)]
    fn set_ball(&mut self, i: usize, ball: Ball<R, D>) -> bool {
        std::mem::replace(&mut self.balls[i], ball) != ball
    }
}

/// Splits the first items off a slice, at most this many.
fn split_front<'a, T>(items: &mut &'a mut [T], count: usize) -> &'a mut [T] {
    let count = count.min(items.len());
    let (front, rest) = std::mem::take(items).split_at_mut(count);
    *items = rest;
    front
}
