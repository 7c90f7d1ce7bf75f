//! A set of small numbers: one bit each.

use crate::parallel;
use crate::tuning::update::{ITEMS_A_TASK, THREADS_FROM};

/// A set of numbers below a capacity. Its memory is kept when it is cleared.
#[derive(Clone, Debug, Default)]
pub(crate) struct BitSet {
    words: Vec<u64>,
}

impl BitSet {
    /// Makes room for all numbers below `capacity`. New ones are not in the set.
    pub(crate) fn resize(&mut self, capacity: usize) {
        self.words.resize(capacity.div_ceil(64), 0);
    }

    /// Adds a number, which must be below the capacity. Returns whether it is new.
    #[inline(always)]
    pub(crate) fn insert(&mut self, i: usize) -> bool {
        let (word, bit) = (&mut self.words[i / 64], 1 << (i % 64));
        let is_new = *word & bit == 0;
        *word |= bit;
        is_new
    }

    /// Adds a number, unless it is beyond the capacity.
    #[inline(always)]
    pub(crate) fn insert_if_room(&mut self, i: usize) {
        if let Some(word) = self.words.get_mut(i / 64) {
            *word |= 1 << (i % 64);
        }
    }

    /// Removes a number, if it is in the set.
    pub(crate) fn remove(&mut self, i: usize) {
        if let Some(word) = self.words.get_mut(i / 64) {
            *word &= !(1 << (i % 64));
        }
    }

    /// Adds these numbers, and makes room for all below `capacity`, as these must be.
    pub(crate) fn insert_all(&mut self, numbers: &[u32], capacity: usize) {
        self.resize(capacity);
        for &i in numbers {
            self.insert(i as usize);
        }
    }

    /// Whether a number, which must be below the capacity, is in the set.
    #[inline(always)]
    pub(crate) fn contains(&self, i: usize) -> bool {
        self.words[i / 64] >> (i % 64) & 1 == 1
    }

    /// Tells whether a number is in the set, without a branch. Beyond the capacity, which must not be 0, the answer is
    /// unspecified.
    pub(crate) fn lookup(&self) -> impl Fn(usize) -> bool + Send + Sync + '_ {
        let words = &self.words[..];
        let last = words.len() - 1;
        move |i| words[(i / 64).min(last)] >> (i % 64) & 1 == 1
    }

    /// The numbers in the set, ascending.
    pub(crate) fn iter(&self) -> impl Iterator<Item = usize> + '_ {
        let numbered = self.words.iter().enumerate();
        numbered.flat_map(|(i, &word)| ones(word).map(move |bit| 64 * i + bit))
    }

    /// The numbers in the set, descending.
    pub(crate) fn iter_backwards(&self) -> impl Iterator<Item = usize> + '_ {
        let numbered = self.words.iter().enumerate().rev();
        numbered.flat_map(|(i, &word)| {
            let backwards = ones(word.reverse_bits());
            backwards.map(move |bit| 64 * i + 63 - bit)
        })
    }

    /// Adds all numbers of a set of the same capacity.
    pub(crate) fn extend_from(&mut self, other: &Self) {
        for (word, more) in self.words.iter_mut().zip(&other.words) {
            *word |= more;
        }
    }

    /// Removes all numbers.
    pub(crate) fn clear(&mut self) {
        self.words.fill(0);
    }

    /// Removes these numbers, and possibly others near them: less work than [`clear`](Self::clear) if there are no
    /// others in the set and these are few.
    pub(crate) fn clear_around(&mut self, numbers: &[u32]) {
        if numbers.len() > self.words.len() {
            return self.clear();
        }
        for &i in numbers {
            self.words[i as usize / 64] = 0;
        }
    }

    /// The words, 64 numbers each, the smallest lowest.
    pub(crate) fn words(&self) -> &[u64] {
        &self.words
    }

    /// Makes it the set of the numbers below `count` for which the answer is yes.
    ///
    /// `ask` answers for up to 64 numbers, from the first of its range on, in the lowest bits. With the feature `parallel`
    /// it is called by several threads if the numbers are many.
    pub(crate) fn ask(
        &mut self,
        count: usize,
        ask: impl Fn(core::ops::Range<usize>) -> u64 + Send + Sync,
    ) {
        self.words.resize(count.div_ceil(64), 0);
        let answer = |i: usize, word: &mut u64| *word = ask(64 * i..count.min(64 * (i + 1)));
        if count < THREADS_FROM || parallel::threads() == 1 {
            let numbered = self.words.iter_mut().enumerate();
            return numbered.for_each(|(i, word)| answer(i, word));
        }
        const WORDS_A_TASK: usize = ITEMS_A_TASK / 64;
        let mut tasks: Vec<_> = self.words.chunks_mut(WORDS_A_TASK).enumerate().collect();
        parallel::for_each(&mut tasks, |(task, words)| {
            let numbered = (*task * WORDS_A_TASK..).zip(words.iter_mut());
            numbered.for_each(|(i, word)| answer(i, word));
        });
    }
}

/// The positions of the bits that are set, ascending.
#[inline(always)]
pub(crate) fn ones(word: u64) -> impl Iterator<Item = usize> {
    let mut rest = word;
    core::iter::from_fn(move || {
        let bit = (rest != 0).then(|| rest.trailing_zeros() as usize)?;
        rest &= rest - 1;
        Some(bit)
    })
}
