//! Reads listed colliders, in the order of their slots.
//!
//! Rapier lists colliders island by island. Once bodies have met, that order jumps around in memory; in the order of slots the processor
//! prefetches. A long list is split into chunks of slots, one for each thread. A collider that needs more than a move, such as a new one, is
//! deferred until all others have been read.

use super::{ColliderSource, Handle, Memo, ProxyTable, Reading};
use crate::bit_set::{BitSet, ones};
use crate::pair_tracker::{FilterKey, Notes, ProxyChunk};
use crate::parallel::Section;
use crate::real::Real;
use crate::tuning::prices::READ;

/// A chunk of consecutive slots, all of them or those of one thread: the proxies, generations and memos.
type SlotChunk<'a, R, const D: usize, M, K> =
    (ProxyChunk<'a, R, D, K>, (&'a [Option<u32>], &'a mut [M]));

impl<R: Real, const D: usize, M: Memo, K: FilterKey> ProxyTable<R, D, M, K> {
    /// Reads the boxes and filter keys of listed colliders.
    pub(super) fn read<S>(&mut self, handles: &[S::Handle], source: &S, margin: R)
    where
        S: ColliderSource<R, D, Memo = M, Key = K>,
    {
        let deferred = self.visit(handles, |proxies, memo, i, handle| {
            let Some(reading) = source.read(handle, memo) else {
                return false;
            };
            let Reading { aabb, key, .. } = reading;
            // Even if this returns false: the memo is up to date now, so a second reading could not tell that more than the pose has changed.
            proxies.follow_volume(i, &aabb, reading.has_only_moved);
            !reading.is_skipped && key == *proxies.key(i) && proxies.follow(i, &aabb, margin)
        });
        for handle in deferred {
            self.admit(handle, margin, |memo| source.read(handle, memo));
        }
    }

    /// Reads the filter key of each listed collider that has changed, or of all, and has the update read its volume. Boxes stay, and unknown
    /// colliders are skipped.
    pub(super) fn read_in_place<S: ColliderSource<R, D, Memo = M, Key = K>>(
        &mut self,
        handles: &[S::Handle],
        source: &S,
        are_all: bool,
    ) {
        let deferred = self.visit(handles, |proxies, memo, i, handle| {
            if !are_all && !source.has_changed_unmoved(handle, memo, proxies.key(i)) {
                return true;
            }
            source.read(handle, memo).is_none_or(|reading| {
                proxies.follow_volume(i, &reading.aabb, false);
                reading.key == *proxies.key(i)
            })
        });
        for handle in deferred {
            let Some(slot) = self.slot_of(handle) else {
                continue;
            };
            if let Some(reading) = source.read(handle, &mut self.memos[slot as usize]) {
                self.tracker.proxies.set_key(slot, reading.key);
            }
        }
    }

    /// The work of reading this many colliders, or of setting their boxes.
    pub(crate) fn reading_section(&self, colliders: usize) -> Section {
        Section::of(colliders, self.tracker.proxies.volumes.price(READ))
    }

    /// Calls `visit` with each known collider, in the order of slots, in one chunk of slots or in one for each thread: with the chunk, its memo,
    /// its index in the chunk, and its handle. Returns the unknown colliders, then those for which `visit` returned false, in the
    /// order of slots.
    fn visit<H: Handle>(
        &mut self,
        handles: &[H],
        visit: impl Fn(&mut ProxyChunk<'_, R, D, K>, &mut M, usize, H) -> bool + Send + Sync,
    ) -> Vec<H> {
        let mut deferred = Vec::new();
        if handles.is_empty() {
            return deferred;
        }
        let section = self.reading_section(handles.len());
        let mut listed = BitSet::default();
        listed.resize(self.generations.len());
        for &handle in handles {
            match self.slot_of(handle) {
                Some(slot) => listed.insert(slot as usize),
                None => deferred.push(handle),
            }
        }
        let slots = 64 * listed.words().len().div_ceil(section.parts()).max(1);
        let words = listed.words().chunks(slots / 64);
        deferred.extend(self.for_chunks(section, slots, words, |words, chunk| {
            let (proxies, (generations, memos)) = chunk;
            let mut deferred = Vec::new();
            for (first, &word) in (0..).step_by(64).zip(*words) {
                for i in ones(word).map(|bit| first + bit) {
                    if let Some(generation) = generations[i] {
                        let handle = H::from_raw_parts(proxies.slot(i), generation);
                        if !visit(proxies, &mut memos[i], i, handle) {
                            deferred.push(handle);
                        }
                    }
                }
            }
            deferred
        }));
        deferred
    }

    /// Calls `work` with each of the `parts` and the next chunk of this many slots, on several threads. Returns what it
    /// returned, in the order of the chunks.
    pub(super) fn for_chunks<T: Send, U: Send>(
        &mut self,
        section: Section,
        slots: usize,
        parts: impl Iterator<Item = T>,
        work: impl Fn(&T, &mut SlotChunk<'_, R, D, M, K>) -> Vec<U> + Send + Sync,
    ) -> Vec<U> {
        let count = self.generations.len().div_ceil(slots);
        self.notes.resize_with(count, Notes::default);
        let memos = self.memos.chunks_mut(slots);
        let known = self.generations.chunks(slots).zip(memos);
        let chunks = self.tracker.proxies.chunks(slots, &mut self.notes);
        let parts = parts.zip(chunks.zip(known));
        let mut parts: Vec<_> = parts.map(|part| (part, Vec::new())).collect();
        section.for_each(&mut parts, |((part, chunk), out)| *out = work(part, chunk));
        let out = parts.into_iter().flat_map(|(_, out)| out).collect();
        for notes in &mut self.notes {
            self.tracker.proxies.notes.append(notes);
        }
        out
    }

    /// Replaces the boxes of known colliders by new ones without a margin.
    pub(super) fn reinsert<S>(&mut self, handles: &[S::Handle], source: &S)
    where
        S: ColliderSource<R, D, Memo = M, Key = K>,
    {
        for &handle in handles {
            let Some(slot) = self.slot_of(handle) else {
                continue;
            };
            let reading = source.read(handle, &mut self.memos[slot as usize]);
            let proxies = &mut self.tracker.proxies;
            if let (Some(reading), Some(held)) = (reading, proxies.get(slot)) {
                let aabb = reading.aabb;
                if aabb != *held && aabb.is_valid() && !reading.is_skipped {
                    proxies.place(slot, aabb);
                }
            }
        }
    }
}
