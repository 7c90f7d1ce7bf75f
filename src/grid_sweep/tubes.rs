//! The boxes, sorted into tubes and by `mins[0]` within each tube.
//!
//! A box has an *entry* in each tube that it spans: its own one in the tube of its `mins`, and a *ghost* in each of the
//! others. Entries are kept as a structure of arrays, tube after tube, so that eight of them are compared at once. After
//! each tube there is a sentinel whose `mins[0]` is NaN, at which every window ends.

use std::ops::Range;

use super::ghosts::{Ghost, MAX_GHOSTS, for_each_tube, write_ghosts};
use super::grid::Grid;
use super::order::Order;
use crate::lanes::LANES;
use crate::tuning::kernel::SPARE_TUBES;
use crate::{Aabb, Real};

/// The entries of one tube are `start..end`; the sentinel is at `end`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tube {
    /// The strip on each cut axis.
    pub(super) strips: [u32; 2],
    pub(super) start: u32,
    pub(super) end: u32,
}

/// All tubes that have entries, ordered by strips.
#[derive(Clone, Debug)]
pub(super) struct Tubes<R, const D: usize> {
    pub(super) tubes: Vec<Tube>,
    /// The numbers, row after row, of the tubes that are dealt with here: all tubes of the grid, or one slab.
    pub(super) range: Range<u32>,
    /// For each tube of the range its position in `tubes`, or [`NOWHERE`]; empty if the grid is much larger than the number
    /// of boxes.
    pub(super) table: Vec<u32>,
    pub(super) mins: [Vec<R>; D],
    pub(super) maxs: [Vec<R>; D],
    /// The index of the box of an entry.
    pub(super) owners: Vec<u32>,
    /// On which cut axes an entry is a ghost: see [`Ghost::axes`].
    pub(super) ghosts: Vec<u8>,
    /// The running maximum of `maxs[0]` in each tube, by entry; empty unless boxes are looked up.
    pub(super) running_maxs: Vec<R>,
    scratch: Scratch<R, D>,
}

/// A box on its way into a tube.
#[derive(Clone, Copy, Debug)]
struct Entry<R, const D: usize> {
    aabb: Aabb<R, D>,
    owner: u32,
    ghost: u8,
}

/// A box on its way into its own tube.
#[derive(Clone, Copy, Debug, Default)]
struct Home {
    /// Its place in the table of tubes.
    tube: u32,
    owner: u32,
}

/// The position of a tube without entries.
pub(super) const NOWHERE: u32 = u32::MAX;

/// Memory kept between calls to spare allocations.
#[derive(Clone, Debug)]
struct Scratch<R, const D: usize> {
    /// The entries, tube after tube, in the order of the boxes.
    entries: Vec<Entry<R, D>>,
    /// For each tube of the table, occupied or not, where its entries go.
    cursors: Vec<u32>,
    /// The boxes whose own tube is in the table, with that tube; entries past their count are unspecified.
    homes: Vec<Home>,
    /// The ghosts; entries past their count are unspecified.
    ghosts: Vec<Ghost>,
    /// Where there is no table: the tube, the owner and the ghost axes of each entry.
    keyed: Vec<(u64, u32, u8)>,
    order: Order<R>,
}

impl<R: Real, const D: usize> Default for Scratch<R, D> {
    fn default() -> Self {
        Self {
            entries: Vec::new(),
            cursors: Vec::new(),
            homes: Vec::new(),
            ghosts: Vec::new(),
            keyed: Vec::new(),
            order: Order::default(),
        }
    }
}

impl<R: Real, const D: usize> Default for Tubes<R, D> {
    fn default() -> Self {
        Self {
            tubes: Vec::new(),
            range: 0..0,
            table: Vec::new(),
            mins: core::array::from_fn(|_| Vec::new()),
            maxs: core::array::from_fn(|_| Vec::new()),
            owners: Vec::new(),
            ghosts: Vec::new(),
            running_maxs: Vec::new(),
            scratch: Scratch::default(),
        }
    }
}

impl<R: Real, const D: usize> Tubes<R, D> {
    /// Whether the grid is small enough for [`build_by_table`](Self::build_by_table) to be the faster way.
    pub(super) fn fits_table(grid: &Grid<R>, members: usize) -> bool {
        // The table must not cost more than the boxes do.
        grid.tube_count() <= (members as u64 + SPARE_TUBES).min(1 << 30)
    }

    /// Enters the members, indices of boxes, into those tubes of the grid whose numbers are in `range`. Outsize ones
    /// are passed over and replace `outsize`.
    ///
    /// Counts the entries of each tube of a table, then places them. Whether a box has a ghost is practically random,
    /// and so is whether it is in the range. So there is no branch on either: homes and ghosts are always written to a
    /// list, which grows by those that exist.
    pub(super) fn build_by_table(
        &mut self,
        boxes: &[Aabb<R, D>],
        members: &[u32],
        grid: &Grid<R>,
        range: Range<u32>,
        outsize: &mut Vec<u32>,
    ) {
        self.clear();
        outsize.clear();
        let columns = grid.axes[1].last + 1;
        let tube_count = range.len() as u32;
        // Tubes out of the range wrap around to large numbers.
        let tube_of = |[row, column]: [u32; 2]| (row * columns + column).wrapping_sub(range.start);
        let Scratch {
            entries,
            cursors,
            homes,
            ghosts,
            ..
        } = &mut self.scratch;
        cursors.clear();
        // One more for those out of the range.
        cursors.resize(tube_count as usize + 1, 0);
        if homes.len() < members.len() {
            homes.resize(members.len(), Home::default());
        }
        let (mut home_count, mut ghost_count) = (0, 0);
        for &owner in members {
            let span = grid.tube_span(&boxes[owner as usize]);
            if span.is_outsize() {
                outsize.push(owner);
                continue;
            }
            let tube = tube_of(span.first);
            homes[home_count] = Home { tube, owner };
            home_count += usize::from(tube < tube_count);
            cursors[tube.min(tube_count) as usize] += 1;
            if ghosts.len() < ghost_count + MAX_GHOSTS {
                ghosts.resize(2 * ghost_count + MAX_GHOSTS, Ghost::default());
            }
            let list = ghosts[ghost_count..]
                .first_chunk_mut()
                .expect("there is room");
            ghost_count += write_ghosts::<D>(&span, owner, tube_of, tube_count, list);
        }
        let (homes, ghosts) = (&homes[..home_count], &ghosts[..ghost_count]);
        for ghost in ghosts {
            cursors[ghost.tube as usize] += 1;
        }

        let mut end = 0;
        cursors.truncate(tube_count as usize);
        for (tube, cursor) in range.clone().zip(cursors.iter_mut()) {
            let start = end;
            end += std::mem::replace(cursor, start);
            let is_occupied = start < end;
            let position = self.tubes.len() as u32;
            self.table
                .push(if is_occupied { position } else { NOWHERE });
            if is_occupied {
                let strips = [tube / columns, tube % columns];
                self.tubes.push(Tube { strips, start, end });
            }
        }

        // All that is read below is written first, so what the last call left need not be cleared.
        if entries.len() < end as usize {
            let aabb = Aabb::new([R::ZERO; D], [R::ZERO; D]);
            entries.resize(
                end as usize,
                Entry {
                    aabb,
                    owner: 0,
                    ghost: 0,
                },
            );
        }
        let mut place = |tube: u32, owner: u32, ghost: u8| {
            let cursor = &mut cursors[tube as usize];
            entries[*cursor as usize] = Entry {
                aabb: boxes[owner as usize],
                owner,
                ghost,
            };
            *cursor += 1;
        };
        for home in homes {
            place(home.tube, home.owner, 0);
        }
        for ghost in ghosts {
            place(ghost.tube, ghost.owner, ghost.axes);
        }
        self.range = range;
        self.sort_tubes();
    }

    /// Frees what only building needs, and is otherwise kept for the next time.
    #[cfg(feature = "_adapter")]
    pub(super) fn free_scratch(&mut self) {
        self.scratch = Scratch::default();
    }

    /// The boxes in their own tubes, with their indices.
    #[cfg(all(feature = "_adapter", feature = "serde-serialize"))]
    pub(super) fn homes(&self) -> impl Iterator<Item = (u32, Aabb<R, D>)> + '_ {
        let entries = self.tubes.iter().flat_map(|tube| tube.start..tube.end);
        let entries = entries.map(|entry| entry as usize);
        entries.filter(|&i| self.ghosts[i] == 0).map(|i| {
            let mins = core::array::from_fn(|k| self.mins[k][i]);
            let maxs = core::array::from_fn(|k| self.maxs[k][i]);
            (self.owners[i], Aabb::new(mins, maxs))
        })
    }

    fn clear(&mut self) {
        self.tubes.clear();
        self.table.clear();
        self.running_maxs.clear();
    }

    /// Enters the members into all tubes by sorting: for boxes so far apart that a table would be mostly empty. Extends
    /// the strips of the grid to the greatest number that they can have.
    pub(super) fn build_by_sorting(
        &mut self,
        boxes: &[Aabb<R, D>],
        members: &[u32],
        grid: &mut Grid<R>,
        outsize: &mut Vec<u32>,
    ) {
        self.clear();
        outsize.clear();
        grid.extend::<D>();
        let Scratch { entries, keyed, .. } = &mut self.scratch;
        keyed.clear();
        for &owner in members {
            let span = grid.tube_span(&boxes[owner as usize]);
            if span.is_outsize() {
                outsize.push(owner);
            } else {
                for_each_tube(&span, |[row, column], ghost| {
                    keyed.push((u64::from(row) << 32 | u64::from(column), owner, ghost));
                });
            }
        }
        keyed.sort_unstable();
        entries.clear();
        for (position, &(key, owner, ghost)) in (0..).zip(keyed.iter()) {
            let strips = [(key >> 32) as u32, key as u32];
            match self.tubes.last_mut() {
                Some(tube) if tube.strips == strips => tube.end += 1,
                _ => self.tubes.push(Tube {
                    strips,
                    start: position,
                    end: position + 1,
                }),
            }
            entries.push(Entry {
                aabb: boxes[owner as usize],
                owner,
                ghost,
            });
        }
        self.range = 0..u32::MAX;
        self.sort_tubes();
    }

    /// Sorts each tube by `mins[0]` into the arrays that are swept, and puts the sentinels between them.
    fn sort_tubes(&mut self) {
        let Self {
            tubes,
            mins,
            maxs,
            owners,
            ghosts,
            scratch,
            ..
        } = self;
        let Scratch { entries, order, .. } = scratch;
        // A sentinel after each tube, and padding: eight lanes may be read from the last entry on.
        let count = tubes.last().map_or(0, |tube| tube.end as usize);
        let padded = count + tubes.len() + LANES;
        for numbers in mins.iter_mut().chain(maxs.iter_mut()) {
            resize_exact(numbers, padded, R::NAN);
        }
        resize_exact(owners, padded, u32::MAX);
        resize_exact(ghosts, padded, 0);
        let mut start = 0;
        for tube in tubes.iter_mut() {
            let entries = &entries[tube.start as usize..tube.end as usize];
            let order = order.sort(entries.iter().map(|entry| entry.aabb.mins[0]));
            let end = start + entries.len();
            // All of one length, so that bounds are checked once.
            let lows = mins.each_mut().map(|column| &mut column[start..end]);
            let highs = maxs.each_mut().map(|column| &mut column[start..end]);
            let places = owners[start..end].iter_mut().zip(&mut ghosts[start..end]);
            for (position, (&(_, i), (owner, ghost))) in order.iter().zip(places).enumerate() {
                let entry = &entries[i as usize];
                for k in 0..D {
                    lows[k][position] = entry.aabb.mins[k];
                    highs[k][position] = entry.aabb.maxs[k];
                }
                *owner = entry.owner;
                *ghost = entry.ghost;
            }
            for column in mins.iter_mut().chain(maxs.iter_mut()) {
                column[end] = R::NAN;
            }
            owners[end] = u32::MAX;
            ghosts[end] = 0;
            (tube.start, tube.end) = (start as u32, end as u32);
            start = end + 1;
        }
        for column in mins.iter_mut().chain(maxs.iter_mut()) {
            column[start..].fill(R::NAN);
        }
        owners[start..].fill(u32::MAX);
        ghosts[start..].fill(0);
    }
}

/// Resizes a list: what it held is kept, `filler` follows, and no more room than that is reserved.
fn resize_exact<T: Copy>(list: &mut Vec<T>, len: usize, filler: T) {
    list.truncate(len);
    list.reserve_exact(len - list.len());
    list.resize(len, filler);
}
