//! Lists of the candidates of each proxy, linked in arrays beside the candidates themselves.

/// The end of a list.
pub(super) const END: u32 = u32::MAX;

/// In the place of a slot: of a candidate that is no more.
pub(super) const GONE: u32 = u32::MAX;

/// The most candidates that links, of 32 bits, can tell apart.
pub(super) const MOST_LINKED: usize = 1 << 30;

/// For each slot a list of its candidates.
///
/// A link is twice the position of a candidate, plus one if the slot in question is its second one.
#[derive(Clone, Debug, Default)]
pub(super) struct Links {
    /// Whether they are up to date.
    pub(super) are_made: bool,
    /// How often they would have been of use since they were not.
    pub(super) wanted: u32,
    /// By slot, the first link.
    pub(super) heads: Vec<u32>,
    /// By candidate, the link that follows for each of its two slots.
    pub(super) next: Vec<[u32; 2]>,
}

impl Links {
    /// Lets them go out of date, until they are made again.
    pub(super) fn forget(&mut self) {
        self.are_made = false;
        self.wanted = 0;
    }

    /// Makes the lists of so many slots.
    pub(super) fn make(&mut self, pairs: &[[u32; 2]], slots: usize) {
        self.heads.clear();
        self.next.clear();
        self.add(pairs, 0, slots);
        self.are_made = true;
    }

    /// Links the candidates from `first` on.
    pub(super) fn add(&mut self, pairs: &[[u32; 2]], first: usize, slots: usize) {
        self.heads.resize(slots, END);
        for (i, pair) in (first as u32..).zip(&pairs[first..]) {
            if pair[0] == GONE {
                self.next.push([END; 2]);
                continue;
            }
            let [a, b] = pair.map(|slot| slot as usize);
            self.next.push([self.heads[a], self.heads[b]]);
            self.heads[a] = 2 * i;
            self.heads[b] = 2 * i + 1;
        }
    }
}
