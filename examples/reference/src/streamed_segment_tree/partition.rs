//! Partitioning a list in place.

/// Moves the items that `come_first` to the front, and splits the list after them. Their order is lost.
///
/// Computes in **O(n)**, without a branch on what comes first: where a set is halved, that is unpredictable.
#[inline(always)]
pub(super) fn partition<T>(
    list: &mut [T],
    come_first: impl Fn(&T) -> bool,
) -> (&mut [T], &mut [T]) {
    let mut first = 0;
    for i in 0..list.len() {
        let comes_first = come_first(&list[i]);
        // If it does not, the next one that does will be swapped with it.
        list.swap(first, i);
        first += usize::from(comes_first);
    }
    list.split_at_mut(first)
}
