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
