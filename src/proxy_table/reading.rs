//! In which order listed colliders are read: as listed, by index, or by index in parts.
//!
//! Rapier lists colliders in the order of its islands, which jumps around in memory once bodies have met. In the
//! order of their indices the processor can foresee the next ones, which halves the time of reading them in scenes
//! too large for the caches. Very many are read in parts, runs of slots, each by one thread.
//!
//! The order affects only speed, not the order of events. What is not a simple move, say a new collider, is dealt with afterwards.

use super::verdict::Verdict;
use super::{BoxSource, Handle, ProxyTable, Reading, is_known};
use crate::bit_set::{BitSet, ones};
use crate::pair_tracker::{FilterKey, Parts, VolumesPart};
use crate::tuning::update::{
    PARTS_A_THREAD, READ_AS_LISTED_UP_TO, READ_BY_INDEX_FROM, THREADS_FROM,
};
use crate::{Aabb, Real, parallel};

/// Goes through listed colliders; keeps its memory between updates.
#[derive(Clone, Debug, Default)]
pub(super) struct Reader {
    /// The slots to read by index.
    listed: BitSet,
    /// By part.
    findings: Vec<Findings>,
}

/// The results of reading a part.
#[derive(Clone, Debug, Default)]
struct Findings {
    /// Slots whose box was renewed.
    moved: Vec<u32>,
    /// Moved slots whose new box has left the fat box.
    escaped: Vec<u32>,
    /// Slots that have another volume, and possibly the same box.
    stirred: Vec<u32>,
    /// Slot and generation of colliders that need more than a move.
    deferred: Vec<(u32, u32)>,
}

/// A run of slots, and what is kept for them.
struct Part<'a, R, const D: usize, M, K> {
    first_slot: usize,
    generations: &'a [Option<u32>],
    memos: &'a mut [M],
    boxes: &'a mut [Aabb<R, D>],
    fat_boxes: &'a [Aabb<R, D>],
    keys: &'a [K],
    volumes: VolumesPart<'a, R, D>,
    has_volumes: bool,
    findings: &'a mut Findings,
}

impl Findings {
    fn clear(&mut self) {
        self.moved.clear();
        self.escaped.clear();
        self.stirred.clear();
        self.deferred.clear();
    }
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
        let slot = self.first_slot + i;
        let handle = S::Handle::from_raw_parts(slot as u32, generation);
        let memo = &mut self.memos[i];
        let verdict = match source.read(handle, memo) {
            Some((aabb, key)) if !source.has_keys() || key == self.keys[i] => {
                let verdict = Verdict::of(&self.boxes[i], &aabb, margin);
                if self.has_volumes && verdict != Verdict::Recheck {
                    let volume = source.volume(handle, memo, &aabb);
                    if volume.kind != self.volumes.kind(i) {
                        return self.findings.deferred.push((slot as u32, generation));
                    }
                    let is_renewed = verdict != Verdict::Keep;
                    // What has another box is compared for that.
                    if self.volumes.set(i, &volume, is_renewed) && !is_renewed {
                        self.findings.stirred.push(slot as u32);
                    }
                }
                verdict
            }
            _ => Verdict::Recheck,
        };
        match verdict {
            Verdict::Keep => {}
            Verdict::Renew(renewed) => {
                self.boxes[i] = renewed;
                self.findings.moved.push(slot as u32);
                if !self.fat_boxes[i].contains(&renewed) {
                    self.findings.escaped.push(slot as u32);
                }
            }
            Verdict::Recheck => self.findings.deferred.push((slot as u32, generation)),
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
                self.findings.deferred.push((slot, generation));
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
        // The order must not depend on the number of threads.
        if handles.len() < READ_BY_INDEX_FROM && is_favourable(handles) {
            self.findings.resize_with(1, Findings::default);
            let mut all = Rest::of(table).part(usize::MAX, &mut self.findings[0]);
            all.read_as_listed(handles, source, margin);
        } else {
            let is_shared = handles.len() >= THREADS_FROM && parallel::threads() > 1;
            for handle in self.list(handles, &table.generations, is_shared) {
                table.admit_read(handle, source, margin);
            }
            self.listed.resize(table.generations.len());
            // More parts than threads, because some will be faster than others.
            let parts = if is_shared {
                PARTS_A_THREAD * parallel::threads()
            } else {
                1
            };
            let words = self.listed.words();
            let words_a_part = words.len().div_ceil(parts).max(1);
            let listed = words.chunks(words_a_part);
            self.findings.resize_with(listed.len(), Findings::default);
            let mut rest = Rest::of(table);
            let parts = listed.zip(&mut self.findings);
            let mut parts: Vec<_> = parts
                .map(|(listed, findings)| (listed, rest.part(64 * words_a_part, findings)))
                .collect();
            parallel::for_each(&mut parts, |(listed, part)| {
                part.read_by_index(listed, source, margin);
            });
            self.listed.clear();
        }
        for findings in &self.findings {
            table.take_in(findings, source, margin);
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
    /// Takes in the results of a part.
    fn take_in<S: BoxSource<R, D, Memo = M, Key = K>>(
        &mut self,
        findings: &Findings,
        source: &S,
        margin: R,
    ) {
        let Findings {
            moved,
            escaped,
            stirred,
            deferred,
        } = findings;
        self.gathered.moved += moved.len();
        self.tracker.note(moved, escaped, stirred);
        for &(slot, generation) in deferred {
            let handle = S::Handle::from_raw_parts(slot, generation);
            self.admit_read(handle, source, margin);
        }
    }

    /// Brings one collider up to date by what its source says.
    pub(super) fn admit_read<S>(&mut self, handle: S::Handle, source: &S, margin: R)
    where
        S: BoxSource<R, D, Memo = M, Key = K>,
    {
        let are_used = self.tracker.volumes().are_used();
        self.admit(handle, margin, |memo| {
            Reading::of(source, handle, memo, are_used)
        });
    }
}

/// The slots that are in no part yet.
struct Rest<'a, R, const D: usize, M, K> {
    first_slot: usize,
    generations: &'a [Option<u32>],
    memos: &'a mut [M],
    boxes: &'a mut [Aabb<R, D>],
    fat_boxes: &'a [Aabb<R, D>],
    keys: &'a [K],
    volumes: VolumesPart<'a, R, D>,
    has_volumes: bool,
}

impl<'a, R: Real, const D: usize, M, K: FilterKey> Rest<'a, R, D, M, K> {
    /// All slots.
    fn of(table: &'a mut ProxyTable<R, D, M, K>) -> Self {
        let has_volumes = table.tracker.volumes().are_used();
        let Parts {
            boxes,
            fat_boxes,
            keys,
            volumes,
        } = table.tracker.parts();
        Self {
            first_slot: 0,
            generations: &table.generations,
            memos: &mut table.memos,
            boxes,
            fat_boxes,
            keys,
            volumes,
            has_volumes,
        }
    }

    /// The next slots, at most this many, with a place for the results of reading them.
    fn part(&mut self, slots: usize, findings: &'a mut Findings) -> Part<'a, R, D, M, K> {
        findings.clear();
        let first_slot = self.first_slot;
        let count = slots.min(self.generations.len());
        self.first_slot += count;
        let memos = std::mem::take(&mut self.memos);
        let boxes = std::mem::take(&mut self.boxes);
        let (memos, rest) = memos.split_at_mut(count);
        self.memos = rest;
        let (boxes, rest) = boxes.split_at_mut(count);
        self.boxes = rest;
        Part {
            first_slot,
            generations: take_front(&mut self.generations, count),
            memos,
            boxes,
            fat_boxes: take_front(&mut self.fat_boxes, count),
            keys: take_front(&mut self.keys, count),
            volumes: self.volumes.split_front(count),
            has_volumes: self.has_volumes,
            findings,
        }
    }
}

/// Splits the first items off a slice.
fn take_front<'a, T>(items: &mut &'a [T], count: usize) -> &'a [T] {
    let (front, rest) = items.split_at(count);
    *items = rest;
    front
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
