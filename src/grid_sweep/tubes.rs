//! The boxes, sorted into tubes and by `mins[0]` within each tube.
//!
//! A box has an *entry* in each tube that it spans: its own one in the tube of its `mins`, and a *ghost* in each of the
//! others. Entries are kept as a structure of arrays, so that eight of them are compared at once. After each tube there is
//! a sentinel whose `mins[0]` is NaN, at which every window ends. If nothing will be looked up, tubes take the place of
//! each other, and the arrays stay in the cache.

use std::ops::Range;

use super::crowd::Crowd;
use super::order::Order;
use super::owner::Owner;
use crate::aabb::Aabb;
use crate::lanes::LANES;
use crate::real::Real;

/// How many entries may be read beyond the last sentinel: the sweep reads at most 64 beyond the last of eight.
pub(super) const PADDING: usize = LANES + 64;

/// A box on its way into a tube.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry<R, const D: usize> {
    pub(super) aabb: Aabb<R, D>,
    pub(super) owner: Owner,
}

/// The entries of one tube are `start..end`; the sentinel is at `end`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tube<R> {
    pub(super) number: u32,
    pub(super) start: u32,
    pub(super) end: u32,
    /// From where to where its boxes reach along the first axis, if boxes are looked up.
    pub(super) reach: [R; 2],
}

/// All tubes that have entries, by number.
#[derive(Clone, Debug)]
pub(super) struct Tubes<R, const D: usize> {
    /// Empty if the tubes are not kept.
    pub(super) tubes: Vec<Tube<R>>,
    /// The numbers of these tubes: all that there are, or one slab.
    pub(super) range: Range<u32>,
    /// For each tube of the range its position in `tubes`, or [`NOWHERE`]; empty unless boxes are looked up.
    pub(super) table: Vec<u32>,
    pub(super) mins: [Vec<R>; D],
    pub(super) maxs: [Vec<R>; D],
    /// A box around those of all entries, if boxes are looked up.
    pub(super) bounds: Option<Aabb<R, D>>,
    /// The tubes among them whose entries crowd, by number, if boxes are looked up.
    pub(super) crowds: Vec<(u32, Crowd<R, D>)>,
    /// Whose an entry is.
    pub(super) owners: Vec<Owner>,
    /// The running maximum of `maxs[0]` in each tube, by entry; empty unless boxes are looked up.
    pub(super) running_maxs: Vec<R>,
    /// Memory kept between calls to spare allocations.
    pub(super) order: Order<R>,
}

/// The position of a tube without entries.
pub(super) const NOWHERE: u32 = u32::MAX;

impl<R: Default, const D: usize> Default for Tubes<R, D> {
    fn default() -> Self {
        Self {
            tubes: Vec::new(),
            range: 0..0,
            table: Vec::new(),
            mins: core::array::from_fn(|_| Vec::new()),
            maxs: core::array::from_fn(|_| Vec::new()),
            bounds: None,
            crowds: Vec::new(),
            owners: Vec::new(),
            running_maxs: Vec::new(),
            order: Order::default(),
        }
    }
}

impl<R: Real, const D: usize> Tubes<R, D> {
    /// Removes all tubes. Those that come have numbers of this range.
    pub(super) fn clear(&mut self, range: Range<u32>) {
        self.range = range;
        self.tubes.clear();
        self.crowds.clear();
        self.table.clear();
        self.running_maxs.clear();
    }

    /// Makes room for so many entries in so many tubes. The first time for no more: few sets of boxes that are kept grow.
    pub(super) fn reserve(&mut self, entries: usize, tubes: usize) {
        let len = entries + tubes + PADDING;
        for numbers in self.mins.iter_mut().chain(self.maxs.iter_mut()) {
            resize(numbers, len, R::NAN);
            // Beyond the last sentinel, where nothing is written.
            numbers[entries + tubes..].fill(R::NAN);
        }
        resize(&mut self.owners, len, Owner::NOBODY);
        self.tubes.reserve(tubes);
    }

    /// Adds the next tube that has entries. They are where it says, until the next tube comes unless this one is kept.
    pub(super) fn push(
        &mut self,
        number: u32,
        entries: &[Entry<R, D>],
        keeps: bool,
    ) -> Range<usize> {
        let start = self.tubes.last().map_or(0, |tube| tube.end as usize + 1);
        let end = start + entries.len();
        if self.owners.len() < end + 1 + PADDING {
            self.grow(end + 1 + PADDING);
        }
        self.sort(start, entries);
        if keeps {
            let (start, end) = (start as u32, end as u32);
            self.tubes.push(Tube {
                number,
                start,
                end,
                reach: [R::ZERO; 2],
            });
        }
        start..end
    }

    /// The crowd in the tube of this number, if there is one.
    #[inline(always)]
    pub(super) fn crowd(&self, number: u32) -> Option<&Crowd<R, D>> {
        if self.crowds.is_empty() {
            return None;
        }
        let position = self.crowds.binary_search_by_key(&number, |&(tube, _)| tube);
        position.ok().map(|i| &self.crowds[i].1)
    }

    /// The owners of all entries that are kept.
    pub(super) fn entries(&self) -> impl Iterator<Item = Owner> + Clone + '_ {
        let tubes = self.tubes.iter();
        tubes
            .flat_map(|tube| &self.owners[tube.start as usize..tube.end as usize])
            .copied()
    }

    #[cold]
    fn grow(&mut self, len: usize) {
        for numbers in self.mins.iter_mut().chain(self.maxs.iter_mut()) {
            numbers.resize(len, R::NAN);
        }
        self.owners.resize(len, Owner::NOBODY);
    }

    /// Sorts entries by `mins[0]` into the arrays, and puts a sentinel after them.
    fn sort(&mut self, start: usize, entries: &[Entry<R, D>]) {
        let (mins, maxs, owners) = (&mut self.mins, &mut self.maxs, &mut self.owners);
        let order = self
            .order
            .sort(entries.iter().map(|entry| entry.aabb.mins[0]));
        let end = start + entries.len();
        // All of one length, so that bounds are checked once.
        let lows = mins.each_mut().map(|column| &mut column[start..end]);
        let highs = maxs.each_mut().map(|column| &mut column[start..end]);
        let owners_here = &mut owners[start..end];
        // Four at a time, so that four numbers are written at once.
        let mut position = 0;
        while let Some(four) = order[position..].first_chunk::<4>() {
            let four = four.map(|(_, i)| &entries[i as usize]);
            for k in 0..D {
                *four_at(lows[k], position) = four.map(|entry| entry.aabb.mins[k]);
                *four_at(highs[k], position) = four.map(|entry| entry.aabb.maxs[k]);
            }
            *four_at(owners_here, position) = four.map(|entry| entry.owner);
            position += 4;
        }
        for (position, &(_, i)) in order.iter().enumerate().skip(position) {
            let entry = &entries[i as usize];
            for k in 0..D {
                lows[k][position] = entry.aabb.mins[k];
                highs[k][position] = entry.aabb.maxs[k];
            }
            owners_here[position] = entry.owner;
        }
        for column in mins.iter_mut().chain(maxs.iter_mut()) {
            column[end] = R::NAN;
        }
        owners[end] = Owner::NOBODY;
    }
}

/// The four items from `start` on.
#[inline(always)]
fn four_at<T>(items: &mut [T], start: usize) -> &mut [T; 4] {
    items[start..]
        .first_chunk_mut()
        .expect("there are as many places as entries")
}

/// Resizes a list: its items stay, and `filler` follows. An empty list gets no more room than that.
fn resize<T: Copy>(list: &mut Vec<T>, len: usize, filler: T) {
    if list.is_empty() {
        list.reserve_exact(len);
    }
    list.resize(len, filler);
}
