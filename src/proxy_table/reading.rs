//! Reads listed colliders, in the order of their slots.
//!
//! Rapier lists colliders island by island. Once bodies have met, that order jumps around in memory. In the order of slots the processor
//! prefetches the next collider, which halves the time to read a scene that does not fit in the caches. A long list is split into chunks
//! of slots, one for each thread.
//!
//! The order only affects speed: events are sorted afterwards. A collider that needs more than a move, such as a new one, is deferred until all
//! others have been read.

use super::slot_chunk::{SlotChunk, slot_chunks};
use super::{ColliderSource, Handle, Memo, ProxyTable, is_known};
use crate::bit_set::{BitSet, ones};
use crate::pair_tracker::{FilterKey, Notes};
use crate::parallel::Section;
use crate::real::Real;
use crate::tuning::prices::READ;

/// Buffers for reading, reused by every update.
#[derive(Clone, Debug, Default)]
pub(super) struct Reader {
    /// The slots to read in the order of slots.
    pub(super) listed: BitSet,
    /// One for each chunk of slots.
    pub(super) notes: Vec<Notes>,
    /// For each chunk of slots, the slot and the generation of the colliders that need more than a move; in the first, also unknown ones.
    deferred: Vec<Vec<(u32, u32)>>,
}

impl Reader {
    /// Lists the slots of known colliders, and defers the other handles.
    fn list<H: Handle>(&mut self, handles: &[H], generations: &[Option<u32>], parts: usize) {
        self.deferred.resize_with(parts, Vec::new);
        self.listed.resize(generations.len());
        for &handle in handles {
            let (slot, generation) = handle.into_raw_parts();
            match is_known(generations, slot, generation) {
                true => _ = self.listed.insert(slot as usize),
                false => self.deferred[0].push((slot, generation)),
            }
        }
    }
}

impl<R: Real, const D: usize, M: Memo, K: FilterKey> ProxyTable<R, D, M, K> {
    /// Reads the boxes and filter keys of listed colliders.
    pub(super) fn read<S>(&mut self, handles: &[S::Handle], source: &S, margin: R)
    where
        S: ColliderSource<R, D, Memo = M, Key = K>,
    {
        self.visit(handles, |chunk, i, handle| {
            chunk.read(i, handle, source, margin)
        });
        self.for_deferred(|table, handle| {
            table.admit(handle, margin, |memo| source.read(handle, memo));
        });
    }

    /// Reads the filter key of each listed collider that `has_changed`, and has the update read its volume. Boxes stay, and unknown colliders
    /// are skipped.
    pub(super) fn read_in_place<S>(
        &mut self,
        handles: &[S::Handle],
        source: &S,
        has_changed: impl Fn(S::Handle, &M, &K) -> bool + Send + Sync,
    ) where
        S: ColliderSource<R, D, Memo = M, Key = K>,
    {
        self.visit(handles, |chunk, i, handle| {
            chunk.read_in_place(i, handle, source, &has_changed)
        });
        self.for_deferred(|table, handle| {
            let Some(slot) = table.slot_of(handle) else {
                return;
            };
            if let Some(reading) = source.read(handle, &mut table.memos[slot as usize]) {
                table.tracker.proxies.set_key(slot, reading.key);
            }
        });
    }

    /// The work of reading this many colliders, or of setting their boxes.
    pub(crate) fn reading_section(&self, colliders: usize) -> Section {
        Section::of(colliders, self.tracker.proxies.volumes.price(READ))
    }

    /// Calls `visit` with each known collider, in the order of slots, in one chunk of slots or in one for each thread: with the chunk, the index
    /// in it, and the handle. Defers the colliders for which it returns false, and unknown ones.
    fn visit<H: Handle>(
        &mut self,
        handles: &[H],
        visit: impl Fn(&mut SlotChunk<'_, R, D, M, K>, usize, H) -> bool + Send + Sync,
    ) {
        if handles.is_empty() {
            return;
        }
        let section = self.reading_section(handles.len());
        let parts = section.parts();
        self.reader.list(handles, &self.generations, parts);
        let Reader {
            listed,
            notes,
            deferred,
        } = &mut self.reader;
        let words_a_part = listed.words().len().div_ceil(parts).max(1);
        let words = listed.words().chunks(words_a_part).zip(deferred);
        let chunks = slot_chunks(
            &mut self.tracker.proxies,
            &self.generations,
            &mut self.memos,
            notes,
            64 * words_a_part,
        );
        let mut parts: Vec<_> = words.zip(chunks).collect();
        section.for_each(&mut parts, |((words, deferred), chunk)| {
            for (first, &word) in (0..).step_by(64).zip(*words) {
                for i in ones(word).map(|bit| first + bit) {
                    if let Some(handle) = chunk.handle::<H>(i) {
                        if !visit(chunk, i, handle) {
                            deferred.push(handle.into_raw_parts());
                        }
                    }
                }
            }
        });
        drop(parts);
        listed.clear();
        for notes in notes {
            self.tracker.proxies.notes.append(notes);
        }
    }

    /// Calls `work` with each deferred collider.
    fn for_deferred<H: Handle>(&mut self, mut work: impl FnMut(&mut Self, H)) {
        let mut deferred = std::mem::take(&mut self.reader.deferred);
        for (slot, generation) in deferred.iter_mut().flat_map(|part| part.drain(..)) {
            work(self, H::from_raw_parts(slot, generation));
        }
        self.reader.deferred = deferred;
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
