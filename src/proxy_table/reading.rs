//! In which order listed colliders are read: as listed, by index, or by index in parts.
//!
//! Rapier lists colliders in the order of its islands, which jumps around in memory once bodies have met. In the
//! order of their indices the processor can foresee the next ones, which halves the time of reading them in scenes
//! too large for the caches. Very many are read in parts, runs of slots, each by one thread.
//!
//! The order affects only speed, not the order of events. What is not a simple move, say a new collider, is dealt with afterwards.

use super::hand_over::HandedOver;
use super::slot_run::{SlotRun, slot_runs};
use super::{BoxSource, Handle, ProxyTable, is_known};
use crate::bit_set::{BitSet, ones};
use crate::pair_tracker::{FilterKey, Notes};
use crate::parallel::Section;
use crate::real::Real;
use crate::tuning::prices::READ;
use crate::tuning::update::{READ_AS_LISTED_UP_TO, READ_BY_INDEX_FROM};

/// Goes through listed colliders; keeps its memory between updates.
#[derive(Clone, Debug, Default)]
pub(super) struct Reader {
    /// The slots to read by index.
    listed: BitSet,
    /// By part.
    pub(super) notes: Vec<Notes>,
    deferred: Vec<Vec<Deferred>>,
}

/// Slot and generation of a collider that needs more than a move.
type Deferred = (u32, u32);

/// A run of slots, and what is kept for them.
struct Part<'a, R, const D: usize, M, K> {
    run: SlotRun<'a, R, D, M, K>,
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
        let handle = self.run.handle(i, generation);
        let SlotRun { proxies, memos, .. } = &mut self.run;
        let memo = &mut memos[i];
        let is_moved = match source.read(handle, memo) {
            Some((aabb, key)) if !source.has_keys() || key == *proxies.key(i) => {
                proxies.follow(i, &aabb, margin, |volumes, is_renewed| {
                    volumes.set(i, &source.volume(handle, memo, &aabb), is_renewed)
                })
            }
            _ => false,
        };
        if !is_moved {
            self.deferred.push(handle.into_raw_parts());
        }
    }

    /// Reads the filter key and the volume of the slot `i` of the part. Its box stays.
    fn read_in_place<S: BoxSource<R, D, Memo = M, Key = K>>(
        &mut self,
        i: usize,
        generation: u32,
        source: &S,
        are_used: bool,
    ) {
        let handle: S::Handle = self.run.handle(i, generation);
        let SlotRun { proxies, memos, .. } = &mut self.run;
        let Some(reading) = source.reading(handle, &mut memos[i], are_used) else {
            return;
        };
        let has_key = reading.key == *proxies.key(i);
        if !(has_key && proxies.set_volume(i, &reading.volume)) {
            self.deferred.push(handle.into_raw_parts());
        }
    }
}

impl Reader {
    /// Lists the slots of the handles whose collider is known, and returns the other handles, in their order.
    fn list<H: Handle>(
        &mut self,
        handles: &[H],
        generations: &[Option<u32>],
        section: Section,
    ) -> Vec<H> {
        let parts = handles.chunks(handles.len().div_ceil(section.parts()).max(1));
        // The first part has the memory that was kept.
        let mut lists: Vec<_> = parts
            .map(|handles| (handles, std::mem::take(&mut self.listed), Vec::new()))
            .collect();
        section.for_each(&mut lists, |(handles, listed, unknown)| {
            listed.resize(generations.len());
            for &handle in *handles {
                let (slot, generation) = handle.into_raw_parts();
                if is_known(generations, slot, generation) {
                    listed.insert(slot as usize);
                } else {
                    unknown.push(handle);
                }
            }
        });
        let all = lists.into_iter().reduce(|mut all, (_, listed, unknown)| {
            all.1.extend_from(&listed);
            all.2.extend(unknown);
            all
        });
        let (_, listed, unknown) = all.unwrap_or_default();
        self.listed = listed;
        unknown
    }
}

impl<R: Real, const D: usize, M: Clone + Default + Send, K: FilterKey> ProxyTable<R, D, M, K> {
    /// Reads the listed colliders.
    pub(super) fn read<S>(&mut self, handles: &[S::Handle], source: &S, margin: R)
    where
        S: BoxSource<R, D, Memo = M, Key = K>,
    {
        let mut touched = self.tracker.proxies.touched().len();
        let count = handles.len();
        let is_sorted = || handles.is_sorted_by_key(|handle| handle.into_raw_parts().0);
        let section = Section::of(count, self.tracker.proxies.volumes().price(READ));
        let is_listed = || count < READ_BY_INDEX_FROM && is_sorted();
        if section.parts() == 1 && (count <= READ_AS_LISTED_UP_TO || is_listed()) {
            self.reader.deferred.resize_with(1, Vec::new);
            let mut all = Part {
                run: SlotRun {
                    proxies: self.tracker.proxies.all(),
                    generations: &self.generations,
                    memos: &mut self.memos,
                },
                deferred: &mut self.reader.deferred[0],
            };
            section.run(|| {
                for handle in handles {
                    let (slot, generation) = handle.into_raw_parts();
                    if is_known(all.run.generations, slot, generation) {
                        all.read(slot as usize, generation, source, margin);
                    } else {
                        all.deferred.push((slot, generation));
                    }
                }
            });
        } else {
            for handle in self.reader.list(handles, &self.generations, section) {
                self.admit_read(handle, None, source, margin);
            }
            touched = self.tracker.proxies.touched().len();
            self.in_parts(section, |part, i, generation| {
                part.read(i, generation, source, margin);
            });
        }
        self.gathered.moved += self.tracker.proxies.touched().len() - touched;
        self.for_deferred(|table, handle| table.admit_read(handle, None, source, margin));
    }

    /// Calls `work` with each collider that was deferred.
    fn for_deferred<H: Handle>(&mut self, mut work: impl FnMut(&mut Self, H)) {
        let mut deferred = std::mem::take(&mut self.reader.deferred);
        for (slot, generation) in deferred.iter_mut().flat_map(|part| part.drain(..)) {
            work(self, H::from_raw_parts(slot, generation));
        }
        self.reader.deferred = deferred;
    }

    /// Calls `read` with the listed slots by index, in parts: with the part, the place in it, and the generation.
    fn in_parts(
        &mut self,
        section: Section,
        read: impl Fn(&mut Part<'_, R, D, M, K>, usize, u32) + Send + Sync,
    ) {
        let Reader {
            listed,
            notes,
            deferred,
        } = &mut self.reader;
        listed.resize(self.generations.len());
        let words_a_part = listed.words().len().div_ceil(section.parts()).max(1);
        let slots_a_part = 64 * words_a_part;
        let words = listed.words().chunks(words_a_part);
        deferred.resize_with(words.len(), Vec::new);
        let proxies = &mut self.tracker.proxies;
        let runs = slot_runs(
            proxies,
            &self.generations,
            &mut self.memos,
            notes,
            slots_a_part,
        );
        let parts = words.zip(runs.zip(deferred));
        let mut parts: Vec<_> = parts
            .map(|(words, (run, deferred))| (words, Part { run, deferred }))
            .collect();
        section.for_each(&mut parts, |(words, part)| {
            for (first, &word) in (0..).step_by(64).zip(*words) {
                for i in ones(word).map(|bit| first + bit) {
                    // If another collider has taken the slot since, it has been read; reading it again changes nothing.
                    if let Some(generation) = part.run.generations[i] {
                        read(part, i, generation);
                    }
                }
            }
        });
        drop(parts);
        listed.clear();
        for notes in notes {
            self.tracker.proxies.note(notes);
        }
    }

    /// Brings one collider up to date by what the source says, and by boxes that were handed over for it, if any.
    pub(super) fn admit_read<S>(
        &mut self,
        handle: S::Handle,
        handed_over: Option<HandedOver<R, D>>,
        source: &S,
        margin: R,
    ) where
        S: BoxSource<R, D, Memo = M, Key = K>,
    {
        let are_used = self.tracker.proxies.volumes().are_used();
        self.admit(handle, margin, |memo| {
            let mut reading = source.reading(handle, memo, are_used)?;
            if let Some(HandedOver { held, last }) = handed_over {
                reading.aabb = held;
                reading.volume = reading.volume.in_box(&last);
            }
            Some(reading)
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

    /// Brings the filter keys and volumes of known colliders up to date, if anything has changed. Boxes stay.
    pub(super) fn read_unmoved<S>(&mut self, handles: &[S::Handle], source: &S)
    where
        S: BoxSource<R, D, Memo = M, Key = K>,
    {
        self.read_in_places(handles, source, |handle, memo| {
            source.has_changed_unmoved(handle, memo)
        });
    }

    /// Brings the volumes of known colliders up to date, whose bodies have changed. Boxes stay.
    pub(super) fn read_swept<S>(&mut self, handles: &[S::Handle], source: &S)
    where
        S: BoxSource<R, D, Memo = M, Key = K>,
    {
        self.read_in_places(handles, source, |_, _| true);
    }

    /// Brings the filter keys and volumes of those of the known colliders up to date that have changed. Boxes stay.
    fn read_in_places<S>(
        &mut self,
        handles: &[S::Handle],
        source: &S,
        have_changed: impl Fn(S::Handle, &M) -> bool + Send + Sync,
    ) where
        S: BoxSource<R, D, Memo = M, Key = K>,
    {
        let volumes = self.tracker.proxies.volumes();
        let (section, are_used) = (
            Section::of(handles.len(), volumes.price(READ)),
            volumes.are_used(),
        );
        if section.parts() == 1 {
            return section.run(|| {
                for &handle in handles {
                    if let Some(slot) = self.slot_of(handle) {
                        if have_changed(handle, &self.memos[slot as usize]) {
                            self.read_in_place(handle, slot, source);
                        }
                    }
                }
            });
        }
        // Those that are not known have nothing to be brought up to date.
        self.reader.list(handles, &self.generations, section);
        self.in_parts(section, |part, i, generation| {
            if have_changed(part.run.handle(i, generation), &part.run.memos[i]) {
                part.read_in_place(i, generation, source, are_used);
            }
        });
        self.for_deferred(|table, handle: S::Handle| {
            if let Some(slot) = table.slot_of(handle) {
                table.read_in_place(handle, slot, source);
            }
        });
    }

    fn read_in_place<S>(&mut self, handle: S::Handle, slot: u32, source: &S)
    where
        S: BoxSource<R, D, Memo = M, Key = K>,
    {
        let are_used = self.tracker.proxies.volumes().are_used();
        let memo = &mut self.memos[slot as usize];
        if let Some(reading) = source.reading(handle, memo, are_used) {
            let proxies = &mut self.tracker.proxies;
            proxies.set_key(slot, reading.key);
            proxies.set_volume(slot, &reading.volume, false);
        }
    }

    /// Reads all volumes again, because what all of them depend on has changed. **O(colliders)**.
    #[cold]
    pub(super) fn reset_volumes<S>(&mut self, source: &S)
    where
        S: BoxSource<R, D, Memo = M, Key = K>,
    {
        for (slot, (&generation, memo)) in (0..).zip(self.generations.iter().zip(&mut self.memos)) {
            let handle = generation.map(|known| S::Handle::from_raw_parts(slot, known));
            let reading = handle.and_then(|handle| source.reading(handle, memo, true));
            if let Some(reading) = reading {
                self.tracker.proxies.reset_volume(slot, &reading.volume);
            }
        }
    }
}
