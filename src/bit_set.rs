//! A set of small numbers: one bit each.

/// A set of numbers below a capacity.
#[derive(Clone, Debug, Default)]
pub(crate) struct BitSet {
    words: Vec<u64>,
}

impl BitSet {
    /// Makes room for all numbers below `capacity`. New ones are not in the set.
    pub(crate) fn resize(&mut self, capacity: usize) {
        self.words.resize(capacity.div_ceil(64), 0);
    }

    /// Adds a number if it is below the capacity.
    #[inline(always)]
    pub(crate) fn insert(&mut self, i: usize) {
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

    /// Whether a number, which must be below the capacity, is in the set.
    #[inline(always)]
    pub(crate) fn contains(&self, i: usize) -> bool {
        self.words[i / 64] >> (i % 64) & 1 == 1
    }

    /// The numbers in the set, ascending.
    pub(crate) fn iter(&self) -> impl Iterator<Item = usize> + '_ {
        let numbered = self.words.iter().enumerate();
        numbered.flat_map(|(i, &word)| ones(word).map(move |bit| 64 * i + bit))
    }

    /// The words, of 64 numbers each; the smallest number is the lowest bit.
    pub(crate) fn words(&self) -> &[u64] {
        &self.words
    }
}

/// The positions of the bits that are set, ascending.
#[inline(always)]
pub(crate) fn ones(word: u64) -> impl Iterator<Item = usize> {
    let mut remaining = word;
    core::iter::from_fn(move || {
        let bit = (remaining != 0).then(|| remaining.trailing_zeros() as usize)?;
        remaining &= remaining - 1;
        Some(bit)
    })
}

/// The answers for up to 64 items, the first one in the lowest bit. There is no branch, because answers are practically random.
#[inline(always)]
pub(crate) fn gather<T>(
    items: impl IntoIterator<Item = T, IntoIter: ExactSizeIterator>,
    ask: impl Fn(T) -> bool,
) -> u64 {
    let items = items.into_iter();
    let unused = 64 - items.len();
    let word = items.fold(0, |word, item| word >> 1 | u64::from(ask(item)) << 63);
    word >> unused
}
