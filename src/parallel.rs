//! Work on several threads, if the feature `parallel` is on, and in a row otherwise.
//!
//! Nothing here changes an outcome: work is cut into parts that do not depend on each other, and what they
//! yield is put together in the order of the parts.

/// Into how many parts work is best cut.
pub(crate) fn threads() -> usize {
    #[cfg(feature = "parallel")]
    return rayon::current_num_threads();
    #[cfg(not(feature = "parallel"))]
    return 1;
}

/// Does two things at once, or one after the other.
pub(crate) fn join<A: Send, B: Send>(
    a: impl FnOnce() -> A + Send,
    b: impl FnOnce() -> B + Send,
) -> (A, B) {
    #[cfg(feature = "parallel")]
    return rayon::join(a, b);
    #[cfg(not(feature = "parallel"))]
    return (a(), b());
}

/// Fewer items than this are not worth a second thread.
#[cfg(all(feature = "parallel", feature = "_adapter"))]
const WORTH_A_THREAD: usize = 1 << 14;

/// Asks a question of each item, and writes the answers into `bits`, 64 in a word, the first one lowest.
///
/// `ask` answers for up to 64 items, from the first of its range on, in the lowest bits.
#[cfg(feature = "_adapter")]
pub(crate) fn ask_each(
    items: usize,
    bits: &mut Vec<u64>,
    ask: impl Fn(core::ops::Range<usize>) -> u64 + Send + Sync,
) {
    bits.resize(items.div_ceil(64), 0);
    let answer = |(i, word): (usize, &mut u64)| {
        *word = ask(64 * i..items.min(64 * (i + 1)));
    };
    #[cfg(feature = "parallel")]
    if items >= WORTH_A_THREAD && threads() > 1 {
        use rayon::prelude::*;
        let words = bits.par_iter_mut().enumerate();
        words.with_min_len(WORTH_A_THREAD / 64 / 4).for_each(answer);
        return;
    }
    bits.iter_mut().enumerate().for_each(answer);
}

/// The positions of the bits that are set.
#[cfg(feature = "_adapter")]
pub(crate) fn ones(bits: &[u64]) -> impl Iterator<Item = usize> + '_ {
    bits.iter().enumerate().flat_map(|(i, &word)| {
        let mut rest = word;
        core::iter::from_fn(move || {
            let bit = (rest != 0).then(|| rest.trailing_zeros() as usize)?;
            rest &= rest - 1;
            Some(64 * i + bit)
        })
    })
}

/// Calls `work` with each part.
pub(crate) fn for_each<T: Send>(parts: &mut [T], work: impl Fn(&mut T) + Send + Sync) {
    #[cfg(feature = "parallel")]
    if parts.len() > 1 && threads() > 1 {
        use rayon::prelude::*;
        parts.par_iter_mut().with_max_len(1).for_each(work);
        return;
    }
    parts.iter_mut().for_each(work);
}

#[cfg(all(test, feature = "_adapter"))]
mod tests {
    use super::*;

    #[test]
    fn every_item_is_asked_once_and_answers_at_its_place() {
        for items in [0, 1, 63, 64, 65, 1000, 100_000] {
            let mut bits = vec![u64::MAX; 7];
            ask_each(items, &mut bits, |range| {
                assert!((1..=64).contains(&range.len()));
                let first = range.start;
                range
                    .filter(|i| i % 3 == 0)
                    .fold(0, |word, i| word | 1 << (i - first))
            });
            assert!(ones(&bits).eq((0..items).step_by(3)));
        }
    }
}
