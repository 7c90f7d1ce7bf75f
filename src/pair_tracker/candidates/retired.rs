//! Held pairs whose candidates are retired, until it is known whether they are found again.

/// The end of a list.
const END: u32 = u32::MAX;

/// A set of pairs that is filled, then emptied, in each update: for each smaller slot a list. Each operation takes constant
/// time but for the length of a list.
#[derive(Clone, Debug, Default)]
pub(super) struct RetiredPairs {
    /// By smaller slot, the first entry of its list.
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
        let smaller = pair[0] as usize;
        if smaller >= self.heads.len() {
            self.heads.resize(smaller + 1, END);
        }
        let entry = self.entries.len() as u32;
        self.entries.push(Entry {
            pair,
            next: std::mem::replace(&mut self.heads[smaller], entry),
            is_taken: false,
        });
    }

    /// Takes a pair out. Returns whether it was in the set.
    pub(super) fn take(&mut self, pair: [u32; 2]) -> bool {
        let Some(&(mut link)) = self.heads.get(pair[0] as usize) else {
            return false;
        };
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
        for entry in self.entries.drain(..) {
            self.heads[entry.pair[0] as usize] = END;
            if !entry.is_taken {
                visit(entry.pair);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::RetiredPairs;

    #[test]
    fn a_pair_is_taken_once_and_the_rest_is_drained() {
        let mut retired = RetiredPairs::default();
        for round in 0..3 {
            for pair in [[1, 2], [1, 3], [7, 9], [0, 5]] {
                retired.insert(pair);
            }
            assert!(retired.take([1, 2]) && !retired.take([1, 2]), "{round}");
            assert!(retired.take([7, 9]) && !retired.take([7, 8]) && !retired.take([8, 9]));
            let mut rest = Vec::new();
            retired.drain(|pair| rest.push(pair));
            assert_eq!(rest, [[1, 3], [0, 5]]);
            assert!(!retired.take([1, 3]));
        }
    }
}
