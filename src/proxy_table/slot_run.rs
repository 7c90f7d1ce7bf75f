//! A run of slots: what one thread works on, or all of them.

use super::{Handle, is_known};
use crate::aabb::Aabb;
use crate::pair_tracker::{FilterKey, Notes, Proxies, ProxyChunk};
use crate::real::Real;
use crate::volume::Volume;

/// What is kept of a run of slots, counted from its first one.
pub(super) struct SlotRun<'a, R, const D: usize, M, K> {
    pub(super) proxies: ProxyChunk<'a, R, D, K>,
    pub(super) generations: &'a [Option<u32>],
    pub(super) memos: &'a mut [M],
}

/// Runs of this many slots each. What threads note is to be [taken in](Proxies::note).
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

impl<R: Real, const D: usize, M, K> SlotRun<'_, R, D, M, K> {
    /// The handle of the collider of the slot at `i`.
    #[inline(always)]
    pub(super) fn handle<H: Handle>(&self, i: usize, generation: u32) -> H {
        H::from_raw_parts(self.proxies.slot(i), generation)
    }

    /// Moves the box at `i`, or lets it stay. Returns false, and changes nothing, if it takes more than a move.
    #[inline(always)]
    pub(super) fn follow(
        &mut self,
        i: usize,
        generation: u32,
        aabb: &Aabb<R, D>,
        margin: R,
        volume: impl FnOnce(&mut M, &Aabb<R, D>) -> Volume<R, D>,
    ) -> bool {
        let memos = &mut self.memos;
        is_known(self.generations, i as u32, generation)
            && self.proxies.follow(i, aabb, margin, |volumes, is_renewed| {
                let by_box = volumes.set_by_box(i, aabb, is_renewed);
                by_box.or_else(|| volumes.set(i, &volume(&mut memos[i], aabb), is_renewed))
            })
    }
}
