//! A range of the proxies, written in place: that of one thread, or all of them; and the notes of what was written.

use crate::aabb::Aabb;
use crate::pair_tracker::volumes::VolumesChunk;
use crate::real::Real;
use crate::volume::VolumeKind;

/// A chunk of slots, numbered from its first one.
pub(crate) struct ProxyChunk<'a, R, const D: usize, K> {
    pub(super) first_slot: usize,
    pub(super) boxes: &'a mut [Aabb<R, D>],
    pub(super) fat_boxes: &'a [Aabb<R, D>],
    pub(super) keys: &'a [K],
    pub(super) volumes: VolumesChunk<'a, R, D>,
    pub(super) notes: &'a mut Notes,
}

impl<R: Real, const D: usize, K> ProxyChunk<'_, R, D, K> {
    /// The slot at `i` of the chunk.
    #[inline(always)]
    pub(crate) fn slot(&self, i: usize) -> u32 {
        (self.first_slot + i) as u32
    }

    /// The filter key of the slot at `i`.
    #[inline(always)]
    pub(crate) fn key(&self, i: usize) -> &K {
        &self.keys[i]
    }

    /// Places or moves the proxy at `i`. `aabb` must be valid.
    #[inline(always)]
    pub(crate) fn place(&mut self, i: usize, aabb: Aabb<R, D>) {
        debug_assert!(aabb.is_valid());
        let slot = self.slot(i);
        self.boxes[i] = aabb;
        self.notes.touched.push(slot);
        if !self.fat_boxes[i].contains(&aabb) {
            self.notes.leavers.push(slot);
        }
    }

    /// Brings the box of the proxy at `i` up to date with that of its collider: it stays if it contains that, and is renewed with a margin if
    /// not. Returns false, and changes nothing, if one of the two is not valid: the collider is new, or must be refused.
    #[inline(always)]
    pub(crate) fn follow(&mut self, i: usize, aabb: &Aabb<R, D>, margin: R) -> bool {
        let present = &self.boxes[i];
        // Which side of a box is passed first is practically random. So `black_box` keeps the compiler from making a branch of each comparison:
        // one branch on the whole condition is predicted better.
        if std::hint::black_box(present.contains(aabb) & aabb.is_valid()) {
            return true;
        }
        let are_valid = present.is_valid() & aabb.is_valid();
        if are_valid {
            let loosened = aabb.loosened(margin);
            // An infinite side minus an infinite margin would be NaN.
            self.place(i, if loosened.is_valid() { loosened } else { *aabb });
        }
        are_valid
    }

    /// Notes that the collider of the proxy at `i` is in this box now, if volumes are in use. A ball follows its box, and other volumes become
    /// stale. `has_only_moved` is false if the collider may have changed in any other way.
    #[inline(always)]
    pub(crate) fn follow_volume(&mut self, i: usize, aabb: &Aabb<R, D>, has_only_moved: bool) {
        let volumes = &mut self.volumes;
        let Some(&kind) = volumes.kinds.get(i) else {
            return;
        };
        let is_asked = match kind {
            VolumeKind::Ball if has_only_moved && !volumes.are_stale[i] => {
                let ball = volumes.balls[i].in_box(&aabb.loosened(volumes.shortfall));
                if volumes.balls[i].change_to(&ball) <= volumes.skin {
                    return;
                }
                volumes.balls[i] = ball;
                volumes.near[i] > 0
            }
            VolumeKind::BoxUntilRead if has_only_moved => false,
            _ => {
                volumes.are_stale[i] = true;
                // The pairs of volumes without half axes do not look whether these are stale. Other pairs do, unless they are near already.
                kind.axes::<D>() == 0 || volumes.near[i] > 0
            }
        };
        if is_asked {
            let slot = self.slot(i);
            self.notes.revolumed.push(slot);
        }
    }
}

/// Notes of which slots were written since the last update, in the order of writing; a slot may repeat. Where several threads write, each has
/// notes of its own.
#[derive(Clone, Debug, Default)]
pub(crate) struct Notes {
    /// Slots whose boxes or keys were written.
    pub(crate) touched: Vec<u32>,
    /// Those of them that the update searches for again: their boxes have left their fat boxes at some time since, are new or gone, or their
    /// keys have changed.
    pub(crate) leavers: Vec<u32>,
    /// Slots whose volumes have changed, or are stale and must be read.
    pub(crate) revolumed: Vec<u32>,
}

impl Notes {
    fn lists(&mut self) -> [&mut Vec<u32>; 3] {
        [&mut self.touched, &mut self.leavers, &mut self.revolumed]
    }

    /// Moves the notes of a thread to the end of these.
    pub(crate) fn append(&mut self, other: &mut Self) {
        for (all, more) in self.lists().into_iter().zip(other.lists()) {
            all.append(more);
        }
    }

    /// Removes repeats from each list that is longer than `most`. **O(log n)** per note, amortized.
    pub(crate) fn forget_repeats(&mut self, most: usize) {
        for list in self.lists() {
            if list.len() > most {
                list.sort_unstable();
                list.dedup();
            }
        }
    }

    pub(super) fn clear(&mut self) {
        self.lists().into_iter().for_each(Vec::clear);
    }
}
