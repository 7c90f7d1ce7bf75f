//! A run of consecutive slots: all of them, or those of one thread.

use super::{BoxSource, Handle, is_known};
use crate::aabb::Aabb;
use crate::pair_tracker::{FilterKey, Notes, Proxies, ProxyChunk};
use crate::real::Real;
use crate::volume::Volume;

/// The data of a run of slots, by index in the run.
pub(super) struct SlotRun<'a, R, const D: usize, M, K> {
    pub(super) proxies: ProxyChunk<'a, R, D, K>,
    pub(super) generations: &'a [Option<u32>],
    pub(super) memos: &'a mut [M],
}

/// Splits all slots into runs of this many. The caller merges their [notes](Proxies::note).
pub(super) fn slot_runs<'a, R: Real, const D: usize, M, K: FilterKey>(
    proxies: &'a mut Proxies<R, D, K>,
    generations: &'a [Option<u32>],
    memos: &'a mut [M],
    notes: &'a mut Vec<Notes>,
    slots: usize,
) -> impl Iterator<Item = SlotRun<'a, R, D, M, K>> {
    notes.resize_with(generations.len().div_ceil(slots), Notes::default);
    let known = generations.chunks(slots).zip(memos.chunks_mut(slots));
    let runs = proxies.chunks(slots, notes).zip(known);
    runs.map(|(proxies, (generations, memos))| SlotRun {
        proxies,
        generations,
        memos,
    })
}

impl<R: Real, const D: usize, M, K: FilterKey> SlotRun<'_, R, D, M, K> {
    /// The handle of the known collider at `i`.
    #[inline(always)]
    pub(super) fn handle<H: Handle>(&self, i: usize) -> Option<H> {
        let generation = self.generations[i]?;
        Some(H::from_raw_parts(self.proxies.slot(i), generation))
    }

    /// Reads the known collider at `i`. Returns false, and changes nothing but the memo, if it needs more than a move.
    #[inline(always)]
    pub(super) fn read<S>(&mut self, i: usize, handle: S::Handle, source: &S, margin: R) -> bool
    where
        S: BoxSource<R, D, Memo = M, Key = K>,
    {
        let Self { proxies, memos, .. } = self;
        let memo = &mut memos[i];
        match source.read(handle, memo) {
            Some((aabb, _)) if source.skips_unbounded() && aabb.is_unbounded() => false,
            Some((aabb, key)) if !source.has_keys() || key == *proxies.key(i) => {
                proxies.follow(i, &aabb, margin, |volumes, is_renewed| {
                    volumes.set(i, &source.volume(handle, memo, &aabb), is_renewed)
                })
            }
            _ => false,
        }
    }

    /// Reads the volume of the known collider at `i` if it `has_changed`; its box stays. Returns false, and changes nothing but the memo, if its
    /// filter key or the kind of its volume has changed.
    #[inline(always)]
    pub(super) fn read_in_place<S>(
        &mut self,
        i: usize,
        handle: S::Handle,
        source: &S,
        has_changed: &impl Fn(S::Handle, &M, &K) -> bool,
    ) -> bool
    where
        S: BoxSource<R, D, Memo = M, Key = K>,
    {
        let Self { proxies, memos, .. } = self;
        let memo = &mut memos[i];
        if !has_changed(handle, memo, proxies.key(i)) {
            return true;
        }
        let reading = source.reading(handle, memo);
        reading.is_none_or(|reading| {
            reading.key == *proxies.key(i) && proxies.set_volume(i, &reading.volume)
        })
    }

    /// Moves a proxy of the run to a box, or keeps the box that it has. Returns false, and changes nothing, if the collider is unknown or needs
    /// more than a move.
    #[inline(always)]
    pub(super) fn follow<H: Handle>(
        &mut self,
        handle: H,
        aabb: &Aabb<R, D>,
        margin: R,
        volume: &impl Fn(H, &mut M, &Aabb<R, D>) -> Volume<R, D>,
    ) -> bool {
        let (slot, generation) = handle.into_raw_parts();
        let place = slot.wrapping_sub(self.proxies.slot(0));
        let (i, memos) = (place as usize, &mut self.memos);
        is_known(self.generations, place, generation)
            && self.proxies.follow(i, aabb, margin, |volumes, is_renewed| {
                volumes
                    .set_by_box(i, aabb, is_renewed)
                    .or_else(|| volumes.set(i, &volume(handle, &mut memos[i], aabb), is_renewed))
            })
    }
}
