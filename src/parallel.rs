//! Work on several threads if the feature `parallel` is on, and on one otherwise.
//!
//! No result depends on the threads: parts of the work do not depend on each other, and their results follow each other in the order
//! of the parts. Whether threads share a section is decided by an estimate of its work, from counts and prices, and never by a clock.

use crate::tuning::threads::{ENTER_COST, PART_FROM, SECTION_COST};

#[cfg(feature = "parallel")]
mod pool;

/// The number of threads that share work here: 1 outside of the [pool].
pub(crate) fn threads() -> usize {
    threads_for(0)
}

/// The number of threads that can share this much `work`. Outside of the [pool], Rayon is asked for it, and starts its global pool for the
/// answer, so it is asked only if the work may be worth it.
fn threads_for(work: u64) -> usize {
    // In a browser, the main thread must not wait, and others start in ways of their own.
    const ARE_THREADS: bool = !cfg!(all(target_family = "wasm", target_os = "unknown"));
    #[cfg(feature = "parallel")]
    if ARE_THREADS && (!is_outside() || work >= ENTER_COST) {
        return rayon::current_num_threads();
    }
    let _ = (work, ARE_THREADS);
    1
}

/// The first item of the part `i` when this many items are divided into equal parts; for the part past the last, their number.
pub(crate) fn start_of_part(i: usize, parts: usize, items: usize) -> usize {
    // The product may need more than the 32 bits that some processors have.
    (i as u64 * items as u64 / parts as u64) as usize
}

/// Runs two functions at once, or one after the other.
pub(crate) fn join<A: Send, B: Send>(
    a: impl FnOnce() -> A + Send,
    b: impl FnOnce() -> B + Send,
) -> (A, B) {
    #[cfg(feature = "parallel")]
    if threads() > 1 {
        return rayon::join(a, b);
    }
    (a(), b())
}

/// Runs a function that consists of sections and takes about this much `work`, in tenths of a nanosecond.
///
/// Much work runs on a thread of the [pool]. From there, waking the other threads takes microseconds. From outside it takes ten times as
/// long, and every section would wait for it.
pub(crate) fn enter<T: Send>(work: u64, run: impl FnOnce() -> T + Send) -> T {
    #[cfg(feature = "parallel")]
    if is_outside() && gain(work, threads_for(work)) >= ENTER_COST {
        return pool::run(run);
    }
    let _ = work;
    run()
}

/// The work that a thread is spared if it shares some with others.
fn gain(work: u64, threads: usize) -> u64 {
    work - work / threads as u64
}

/// Whether the current thread is not in the [pool].
fn is_outside() -> bool {
    #[cfg(feature = "parallel")]
    return !pool::is_inside();
    #[cfg(not(feature = "parallel"))]
    return true;
}

/// A part of an update that several threads can share.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Section {
    /// In tenths of a nanosecond on one thread.
    pub(crate) work: u64,
}

impl Section {
    /// A section of `count` items that take about `price` tenths of a nanosecond each on one thread.
    pub(crate) fn of(count: usize, price: u64) -> Self {
        Self {
            work: price.saturating_mul(count as u64),
        }
    }

    /// The best number of parts.
    pub(crate) fn parts(self) -> usize {
        let cost = match is_outside() {
            true => ENTER_COST,
            false => SECTION_COST,
        };
        let most = usize::try_from(self.work / PART_FROM).unwrap_or(usize::MAX);
        match threads_for(self.work).min(most) {
            parts if parts > 1 && gain(self.work, parts) >= cost => parts,
            _ => 1,
        }
    }

    /// Calls `work` with each part, on several threads if there are several parts.
    pub(crate) fn for_each<T: Send>(self, parts: &mut [T], work: impl Fn(&mut T) + Send + Sync) {
        #[cfg(feature = "parallel")]
        if parts.len() > 1 {
            return enter(self.work, || {
                if threads() == 1 {
                    return parts.iter_mut().for_each(work);
                }
                use rayon::prelude::*;
                parts.par_iter_mut().with_max_len(1).for_each(work);
            });
        }
        parts.iter_mut().for_each(work);
    }
}

/// Runs a test in a pool with this number of threads, of which it uses one without the feature `parallel`.
#[cfg(test)]
pub(crate) fn with_threads<T: Send>(count: usize, test: impl FnOnce() -> T + Send) -> T {
    #[cfg(feature = "parallel")]
    return pool::start(count)
        .expect("there are threads to be had")
        .install(test);
    #[cfg(not(feature = "parallel"))]
    return (count, test()).1;
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
