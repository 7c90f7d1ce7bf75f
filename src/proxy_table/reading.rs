//! In which order listed colliders are read: as listed, by index, or by index in parts.
//!
//! Rapier lists colliders in the order of its islands, which jumps around in memory once bodies have met. In the
//! order of their indices the processor can foresee the next ones, which halves the time of reading them in scenes
//! too large for the caches. Very many are read in parts, runs of slots, each by one thread.
//!
//! The order affects only speed, not the order of events. What is not a simple move, say a new collider, is dealt with afterwards.

use super::{BoxSource, Handle, ProxyTable, Reading, is_known};
use crate::bit_set::{BitSet, ones};
use crate::pair_tracker::{FilterKey, Notes, ProxyChunk};
use crate::parallel;
use crate::real::Real;
use crate::tuning::update::{
    PARTS_A_THREAD, READ_AS_LISTED_UP_TO, READ_BY_INDEX_FROM, THREADS_FROM,
};

/// Goes through listed colliders; keeps its memory between updates.
#[derive(Clone, Debug, Default)]
pub(super) struct Reader {
    /// The slots to read by index.
    listed: BitSet,
    /// By part.
    notes: Vec<Notes>,
    deferred: Vec<Vec<Deferred>>,
}

/// Slot and generation of a collider that needs more than a move.
type Deferred = (u32, u32);

/// A run of slots, and what is kept for them.
struct Part<'a, R, const D: usize, M, K> {
    proxies: ProxyChunk<'a, R, D, K>,
    generations: &'a [Option<u32>],
    memos: &'a mut [M],
    deferred: &'a mut Vec<Deferred>,
}

impl<R: Real, const D: usize, M, K: FilterKey> Part<'_, R, D, M, K> {
    /// Reads the collider of the slot `i` of the part.
    #[inline(always)]
    fn read<S: BoxSource<R, D, Memo = M, Key = K>>(
        &mut self,
        i: usize,
        generation: u32,
        source: &S,
        margin: R,
    ) {
        let slot = self.proxies.slot(i);
        let handle = S::Handle::from_raw_parts(slot, generation);
        let memo = &mut self.memos[i];
        let is_moved = match source.read(handle, memo) {
            Some((aabb, key)) if !source.has_keys() || key == *self.proxies.key(i) => self
                .proxies
                .follow(i, &aabb, margin, |volumes, is_renewed| {
                    volumes.set(i, &source.volume(handle, memo, &aabb), is_renewed)
                }),
            _ => false,
        };
        if !is_moved {
            self.deferred.push((slot, generation));
        }
    }

    /// Reads handles as they are listed; the part must be all slots.
    fn read_as_listed<S: BoxSource<R, D, Memo = M, Key = K>>(
        &mut self,
        handles: &[S::Handle],
        source: &S,
        margin: R,
    ) {
        for handle in handles {
            let (slot, generation) = handle.into_raw_parts();
            if is_known(self.generations, slot, generation) {
                self.read(slot as usize, generation, source, margin);
            } else {
                self.deferred.push((slot, generation));
            }
        }
    }

    /// Reads the slots of the part whose bits are set, by index.
    fn read_by_index<S: BoxSource<R, D, Memo = M, Key = K>>(
        &mut self,
        listed: &[u64],
        source: &S,
        margin: R,
    ) {
        for (first, &word) in (0..).step_by(64).zip(listed) {
            for i in ones(word).map(|bit| first + bit) {
                // If another collider has taken the slot since, it has been read; reading it again changes nothing.
                if let Some(generation) = self.generations[i] {
                    self.read(i, generation, source, margin);
                }
            }
        }
    }
}

impl Reader {
    /// Reads the listed colliders into the table.
    pub(super) fn read<R: Real, const D: usize, S: BoxSource<R, D>>(
        &mut self,
        table: &mut ProxyTable<R, D, S::Memo, S::Key>,
        handles: &[S::Handle],
        source: &S,
        margin: R,
    ) {
        let mut touched = table.tracker.proxies.touched().len();
        // The order must not depend on the number of threads.
        if handles.len() < READ_BY_INDEX_FROM && is_favourable(handles) {
            self.deferred.resize_with(1, Vec::new);
            let mut all = Part {
                proxies: table.tracker.proxies.all(),
                generations: &table.generations,
                memos: &mut table.memos,
                deferred: &mut self.deferred[0],
            };
            all.read_as_listed(handles, source, margin);
        } else {
            let is_shared = handles.len() >= THREADS_FROM && parallel::threads() > 1;
            for handle in self.list(handles, &table.generations, is_shared) {
                table.admit_read(handle, source, margin);
            }
            touched = table.tracker.proxies.touched().len();
            self.read_in_parts(table, is_shared, source, margin);
        }
        table.gathered.moved += table.tracker.proxies.touched().len() - touched;
        for (slot, generation) in self.deferred.iter_mut().flat_map(|part| part.drain(..)) {
            let handle = S::Handle::from_raw_parts(slot, generation);
            table.admit_read(handle, source, margin);
        }
    }

    /// Reads the listed slots by index.
    fn read_in_parts<R: Real, const D: usize, S: BoxSource<R, D>>(
        &mut self,
        table: &mut ProxyTable<R, D, S::Memo, S::Key>,
        is_shared: bool,
        source: &S,
        margin: R,
    ) {
        self.listed.resize(table.generations.len());
        // More parts than threads, because some will be faster than others.
        let parts = match is_shared {
            true => PARTS_A_THREAD * parallel::threads(),
            false => 1,
        };
        let words = self.listed.words();
        let words_a_part = words.len().div_ceil(parts).max(1);
        let slots_a_part = 64 * words_a_part;
        let listed = words.chunks(words_a_part);
        self.notes.resize_with(listed.len(), Notes::default);
        self.deferred.resize_with(listed.len(), Vec::new);
        let chunks = table.tracker.proxies.chunks(slots_a_part, &mut self.notes);
        let generations = table.generations.chunks(slots_a_part);
        let memos = table.memos.chunks_mut(slots_a_part);
        let known = generations.zip(memos).zip(&mut self.deferred);
        let parts = chunks
            .zip(known)
            .map(|(proxies, ((generations, memos), deferred))| Part {
                proxies,
                generations,
                memos,
                deferred,
            });
        let mut parts: Vec<_> = listed.zip(parts).collect();
        parallel::for_each(&mut parts, |(listed, part)| {
            part.read_by_index(listed, source, margin);
        });
        drop(parts);
        self.listed.clear();
        for notes in &mut self.notes {
            table.tracker.proxies.note(notes);
        }
    }

    /// Lists the slots of the handles whose collider is known, and returns the other handles, in their order.
    fn list<H: Handle>(
        &mut self,
        handles: &[H],
        generations: &[Option<u32>],
        is_shared: bool,
    ) -> Vec<H> {
        self.listed.resize(generations.len());
        if !is_shared {
            return list_known(handles, generations, &mut self.listed);
        }
        let chunk = handles.len().div_ceil(parallel::threads()).max(1);
        let mut lists: Vec<_> = handles
            .chunks(chunk)
            .map(|handles| (handles, BitSet::default(), Vec::new()))
            .collect();
        parallel::for_each(&mut lists, |(handles, listed, unknown)| {
            listed.resize(generations.len());
            *unknown = list_known(handles, generations, listed);
        });
        let mut all_unknown = Vec::new();
        for (_, listed, mut unknown) in lists {
            self.listed.extend_from(&listed);
            all_unknown.append(&mut unknown);
        }
        all_unknown
    }
}

impl<R: Real, const D: usize, M: Clone + Default + Send, K: FilterKey> ProxyTable<R, D, M, K> {
    /// Brings one collider up to date by what the source says.
    fn admit_read<S>(&mut self, handle: S::Handle, source: &S, margin: R)
    where
        S: BoxSource<R, D, Memo = M, Key = K>,
    {
        let are_used = self.tracker.proxies.volumes().are_used();
        self.admit(handle, margin, |memo| {
            Reading::of(source, handle, memo, are_used)
        });
    }

    /// Renews the boxes of known colliders without a margin.
    pub(super) fn reinsert<S>(&mut self, handles: &[S::Handle], source: &S)
    where
        S: BoxSource<R, D, Memo = M, Key = K>,
    {
        for &handle in handles {
            let Some(slot) = self.slot_of(handle) else {
                continue;
            };
            let read = source.read(handle, &mut self.memos[slot as usize]);
            let held = self.tracker.proxies.get(slot);
            if let (Some((aabb, _)), Some(held)) = (read, held) {
                if aabb != *held {
                    self.tracker.proxies.place(slot, aabb);
                    self.gathered.moved += 1;
                }
            }
        }
    }

    /// Brings the filter keys of known colliders up to date, and whether they have volumes at all. Boxes stay.
    pub(super) fn read_keys<S>(&mut self, handles: &[S::Handle], source: &S)
    where
        S: BoxSource<R, D, Memo = M, Key = K>,
    {
        let proxies = &mut self.tracker.proxies;
        let are_used = proxies.volumes().are_used();
        for &handle in handles {
            let (slot, generation) = handle.into_raw_parts();
            if !is_known(&self.generations, slot, generation) {
                continue;
            }
            let memo = &mut self.memos[slot as usize];
            let Some(Reading { key, volume, .. }) = Reading::of(source, handle, memo, are_used)
            else {
                continue;
            };
            proxies.set_key(slot, key);
            if are_used && proxies.volumes().get(slot).kind != volume.kind {
                proxies.set_volume(slot, &volume, false);
            }
        }
    }
}

/// Adds the slots of the handles whose collider is known, and returns the other handles, in their order.
fn list_known<H: Handle>(
    handles: &[H],
    generations: &[Option<u32>],
    listed: &mut BitSet,
) -> Vec<H> {
    let mut unknown = Vec::new();
    for &handle in handles {
        let (slot, generation) = handle.into_raw_parts();
        if is_known(generations, slot, generation) {
            listed.insert(slot as usize);
        } else {
            unknown.push(handle);
        }
    }
    unknown
}

/// Whether the order of these handles is good enough as it is.
fn is_favourable<H: Handle>(handles: &[H]) -> bool {
    let is_sorted = || handles.is_sorted_by_key(|handle| handle.into_raw_parts().0);
    handles.len() <= READ_AS_LISTED_UP_TO || is_sorted()
}
