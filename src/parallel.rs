//! Work on several threads if the feature `parallel` is on, and on one otherwise.
//!
//! Nothing here changes a result: work is cut into parts that do not depend on each other, and their
//! results are put together in the order of the parts.

/// The number of parts into which work is best cut.
pub(crate) fn threads() -> usize {
    #[cfg(feature = "parallel")]
    return rayon::current_num_threads();
    #[cfg(not(feature = "parallel"))]
    return 1;
}

/// Where the part `i` of so many equal ones begins among the items; the part after the last begins at their end.
pub(crate) fn start_of_part(i: usize, parts: usize, items: usize) -> usize {
    // The product may need more than the 32 bits that some processors have.
    (i as u64 * items as u64 / parts as u64) as usize
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_of_many_items_follow_each_other() {
        // Products of 2^41, of more than 2^32, and of less.
        for (parts, items) in [(1 << 20, 1 << 21), (8192, 1 << 21), (7, 1 << 29), (3, 2)] {
            let mut end = 0;
            for i in 0..parts {
                let [start, next] = [i, i + 1].map(|i| start_of_part(i, parts, items));
                let len = next - start;
                assert!(start == end && (items / parts..=items.div_ceil(parts)).contains(&len));
                end = next;
            }
            assert_eq!(end, items);
        }
    }
}
