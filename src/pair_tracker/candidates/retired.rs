//! Held pairs whose candidates are retired, until it is known whether they are found again.

/// The end of a list.
const END: u32 = u32::MAX;

/// A hash set of pairs that is filled, then emptied, in each update.
#[derive(Clone, Debug, Default)]
pub(super) struct RetiredPairs {
    /// By hash, the first entry of a list. As many as a power of two, and at least as many as entries.
    heads: Vec<u32>,
    entries: Vec<Entry>,
}

#[derive(Clone, Copy, Debug)]
struct Entry {
    pair: [u32; 2],
    next: u32,
    is_taken: bool,
}

impl RetiredPairs {
    /// Adds a pair that is not in the set.
    pub(super) fn insert(&mut self, pair: [u32; 2]) {
        if self.entries.len() >= self.heads.len() {
            self.grow();
        }
        let link = self.entries.len() as u32;
        let head = hash(pair, self.heads.len());
        self.entries.push(Entry {
            pair,
            next: std::mem::replace(&mut self.heads[head], link),
            is_taken: false,
        });
    }

    /// Takes a pair out. Returns whether it was in the set.
    pub(super) fn take(&mut self, pair: [u32; 2]) -> bool {
        if self.entries.is_empty() {
            return false;
        }
        let mut link = self.heads[hash(pair, self.heads.len())];
        while link != END {
            let entry = &mut self.entries[link as usize];
            if entry.pair == pair {
                return !std::mem::replace(&mut entry.is_taken, true);
            }
            link = entry.next;
        }
        false
    }

    /// Empties the set, and calls `visit` with each pair that was left.
    pub(super) fn drain(&mut self, mut visit: impl FnMut([u32; 2])) {
        let heads = self.heads.len();
        for entry in self.entries.drain(..) {
            self.heads[hash(entry.pair, heads)] = END;
            if !entry.is_taken {
                visit(entry.pair);
            }
        }
    }

    #[cold]
    fn grow(&mut self) {
        let heads = (2 * self.heads.len()).max(64);
        self.heads.clear();
        self.heads.resize(heads, END);
        for (link, entry) in (0..).zip(&mut self.entries) {
            entry.next = std::mem::replace(&mut self.heads[hash(entry.pair, heads)], link);
        }
    }
}

/// A number below `count`, a power of two above 1. Fibonacci hashing (Knuth, The Art of Computer Programming, 6.4).
#[inline(always)]
fn hash([a, b]: [u32; 2], count: usize) -> usize {
    let key = u64::from(a) << 32 | u64::from(b);
    (key.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> (64 - count.trailing_zeros())) as usize
}

#[cfg(test)]
mod tests {
    use super::RetiredPairs;

    #[test]
    fn a_pair_is_taken_once_and_the_rest_is_drained() {
        let mut retired = RetiredPairs::default();
        for count in [3, 1000, 50, 0] {
            (0..count).for_each(|i| retired.insert([i / 7, i + 1]));
            for i in (0..count).filter(|i| i % 3 > 0) {
                assert!(retired.take([i / 7, i + 1]) && !retired.take([i / 7, i + 1]));
                assert!(!retired.take([i / 7 + 1000, i + 1]));
            }
            let mut rest = Vec::new();
            retired.drain(|pair| rest.push(pair));
            let expected = (0..count).filter(|i| i % 3 == 0);
            assert!(rest.into_iter().eq(expected.map(|i| [i / 7, i + 1])));
            assert!(!retired.take([0, 1]));
        }
    }
}
