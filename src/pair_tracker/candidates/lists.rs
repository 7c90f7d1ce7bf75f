//! Lists through the array of candidates: for each slot, the rows in which it occurs.

use super::TOMBSTONE;
use crate::tuning::prices::{LISTED, PICKED, WALKED};

/// The end of a list.
const END: u32 = u32::MAX;

/// The most rows that 32-bit links can number.
const MOST_ROWS: usize = 1 << 30;

/// Picks from all candidates. Making the lists costs about as much as this many. If larger: the lists come late. If smaller: they are made,
/// and dropped unused at the next full search.
const LISTS_COST: u32 = 8;

/// For each slot a list of its rows, where one slot in thousands moves: on the tile map in 3D, updates with lists take 0.34 of the time
/// that they take without.
///
/// A link is twice a row, plus one if the slot in question is the second one of its pair. Lists run through tombstones; each walk removes
/// those from its own list.
#[derive(Clone, Debug, Default)]
pub(super) struct CandidateLists {
    pub(super) are_made: bool,
    /// How often walking them would have been cheaper while they were not made.
    missed: u32,
    /// By slot, the first link.
    heads: Vec<u32>,
    /// By row, the link that follows for each of its two slots.
    next: Vec<[u32; 2]>,
}

impl CandidateLists {
    /// Whether walking the lists of some of all slots is cheaper than picking their candidates from all rows.
    pub(super) fn pay(walked: usize, slots: usize, rows: usize) -> bool {
        let [listed, slots, all] = [walked, slots, rows].map(|count| count as u64);
        // Each candidate is in two lists.
        let candidates = 2 * all * listed / slots.max(1);
        LISTED * listed + WALKED * candidates < PICKED * all && rows <= MOST_ROWS
    }

    /// Whether they have been missed often enough to be made. If not, they have been missed once more.
    pub(super) fn are_due(&mut self) -> bool {
        let are_due = self.missed >= LISTS_COST;
        self.missed += u32::from(!are_due);
        are_due
    }

    /// Lets the lists go out of date, until they are made again.
    pub(super) fn forget(&mut self) {
        self.are_made = false;
        self.missed = 0;
    }

    /// Makes the lists of this many slots.
    pub(super) fn make(&mut self, pairs: &[[u32; 2]], slots: usize) {
        self.heads.clear();
        self.next.clear();
        self.are_made = true;
        self.extend(pairs, 0, slots);
    }

    /// Adds the rows from `first` on, if the lists are made.
    pub(super) fn extend(&mut self, pairs: &[[u32; 2]], first: usize, slots: usize) {
        if pairs.len() > MOST_ROWS {
            self.forget();
        }
        if !self.are_made {
            return;
        }
        self.heads.resize(slots, END);
        for (row, &pair) in pairs.iter().enumerate().skip(first) {
            let link = 2 * row as u32;
            self.next.push(match pair {
                [TOMBSTONE, _] => [END; 2],
                pair => {
                    let [a, b] = pair.map(|slot| slot as usize);
                    let next = [self.heads[a], self.heads[b]];
                    self.heads[a] = link;
                    self.heads[b] = link + 1;
                    next
                }
            });
        }
    }

    /// Calls `visit` with each row in the list of a slot, tombstones included. Removes a row from the list if `visit` returns false.
    pub(super) fn walk(&mut self, slot: u32, mut visit: impl FnMut(usize) -> bool) {
        let Some(&head) = self.heads.get(slot as usize) else {
            return;
        };
        let mut link = head;
        let mut last: Option<(usize, usize)> = None;
        while link != END {
            let (row, side) = (link as usize / 2, link as usize % 2);
            let next = self.next[row][side];
            if visit(row) {
                last = Some((row, side));
            } else {
                match last {
                    None => self.heads[slot as usize] = next,
                    Some((row, side)) => self.next[row][side] = next,
                }
            }
            link = next;
        }
    }

    /// Panics unless each candidate is in the lists of its two slots, if the lists are made.
    pub(super) fn validate(&self, pairs: &[[u32; 2]]) {
        if !self.are_made {
            return;
        }
        let mut count = 0;
        for (slot, &head) in (0..).zip(&self.heads) {
            let mut link = head;
            while link != END {
                let (row, side) = (link as usize / 2, link as usize % 2);
                if pairs[row][0] != TOMBSTONE {
                    assert_eq!(pairs[row][side], slot, "a row in the wrong list");
                    count += 1;
                }
                link = self.next[row][side];
            }
        }
        let candidates = pairs.iter().filter(|pair| pair[0] != TOMBSTONE);
        assert_eq!(count, 2 * candidates.count(), "a candidate is in no list");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_pay_for_few_slots_of_many_rows() {
        // Walking the lists of 20 of 1000 slots, with their share of the rows, is cheaper than picking from more rows than this.
        let rows = (20 * LISTED * 1000 / (1000 * PICKED - 2 * 20 * WALKED)) as usize;
        // The lists of as many slots as this hold so many rows that they never pay.
        let many = (1000 * PICKED / (2 * WALKED)) as usize;
        for (walked, rows, pay) in [
            (20, rows + 1, true),
            (20, rows, false),
            (many, 1 << 30, false),
            (1, MOST_ROWS, true),
            (1, MOST_ROWS + 1, false),
        ] {
            assert_eq!(
                CandidateLists::pay(walked, 1000, rows),
                pay,
                "{walked} {rows}"
            );
        }
    }

    #[test]
    fn lists_are_due_once_they_were_missed_often_enough() {
        let mut lists = CandidateLists::default();
        assert!((0..LISTS_COST).all(|_| !lists.are_due()));
        assert!(lists.are_due() && lists.are_due());
        lists.forget();
        assert!(!lists.are_due());
    }
}
