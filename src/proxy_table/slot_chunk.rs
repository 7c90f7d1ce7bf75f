//! A chunk of consecutive slots: all of them, or those of one thread.

use super::{ColliderSource, Handle, Reading, is_known};
use crate::aabb::Aabb;
use crate::pair_tracker::{FilterKey, Notes, Proxies, ProxyChunk};
use crate::real::Real;

/// The data of a chunk of slots, by index in the chunk.
pub(super) struct SlotChunk<'a, R, const D: usize, M, K> {
    pub(super) proxies: ProxyChunk<'a, R, D, K>,
    pub(super) generations: &'a [Option<u32>],
    pub(super) memos: &'a mut [M],
}

/// Splits all slots into chunks of this many. The caller merges their [notes](Proxies::note).
pub(super) fn slot_chunks<'a, R: Real, const D: usize, M, K: FilterKey>(
    proxies: &'a mut Proxies<R, D, K>,
    generations: &'a [Option<u32>],
    memos: &'a mut [M],
    notes: &'a mut Vec<Notes>,
    slots: usize,
) -> impl Iterator<Item = SlotChunk<'a, R, D, M, K>> {
    notes.resize_with(generations.len().div_ceil(slots), Notes::default);
    let known = generations.chunks(slots).zip(memos.chunks_mut(slots));
    let chunks = proxies.chunks(slots, notes).zip(known);
    chunks.map(|(proxies, (generations, memos))| SlotChunk {
        proxies,
        generations,
        memos,
    })
}

impl<R: Real, const D: usize, M, K: FilterKey> SlotChunk<'_, R, D, M, K> {
    /// The handle of the known collider at `i`.
    #[inline(always)]
    pub(super) fn handle<H: Handle>(&self, i: usize) -> Option<H> {
        let generation = self.generations[i]?;
        Some(H::from_raw_parts(self.proxies.slot(i), generation))
    }

    /// Reads the known collider at `i`. Returns false if its box or its key needs more than a move.
    #[inline(always)]
    pub(super) fn read<S>(&mut self, i: usize, handle: S::Handle, source: &S, margin: R) -> bool
    where
        S: ColliderSource<R, D, Memo = M, Key = K>,
    {
        let Self { proxies, memos, .. } = self;
        let Some(reading) = source.read(handle, &mut memos[i]) else {
            return false;
        };
        let Reading { aabb, key, .. } = reading;
        // Even if this returns false: the memo is up to date now, so a second reading could not tell that more than the pose has changed.
        proxies.follow_volume(i, &aabb, reading.has_only_moved);
        !reading.is_skipped && key == *proxies.key(i) && proxies.follow(i, &aabb, margin)
    }

    /// Has the volume of the known collider at `i` read if it `has_changed`; its box stays. Returns false if its filter key has changed.
    #[inline(always)]
    pub(super) fn read_in_place<S>(
        &mut self,
        i: usize,
        handle: S::Handle,
        source: &S,
        has_changed: &impl Fn(S::Handle, &M, &K) -> bool,
    ) -> bool
    where
        S: ColliderSource<R, D, Memo = M, Key = K>,
    {
        let Self { proxies, memos, .. } = self;
        if !has_changed(handle, &memos[i], proxies.key(i)) {
            return true;
        }
        source.read(handle, &mut memos[i]).is_none_or(|reading| {
            proxies.follow_volume(i, &reading.aabb, false);
            reading.key == *proxies.key(i)
        })
    }

    /// Moves a proxy of the chunk to a box, or keeps the box that it has. Returns false, and leaves its box, if the collider is unknown
    /// or needs more than a move.
    #[inline(always)]
    pub(super) fn follow<H: Handle>(&mut self, handle: H, aabb: &Aabb<R, D>, margin: R) -> bool {
        let (slot, generation) = handle.into_raw_parts();
        let place = slot.wrapping_sub(self.proxies.slot(0));
        is_known(self.generations, place, generation) && {
            self.proxies.follow_volume(place as usize, aabb, true);
            self.proxies.follow(place as usize, aabb, margin)
        }
    }
}
