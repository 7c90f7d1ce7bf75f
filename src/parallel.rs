//! Work on several threads if the feature `parallel` is on, and on one otherwise.
//!
//! Nothing here changes a result: work is cut into parts that do not depend on each other, and their results are put together in the
//! order of the parts. Whether a section is shared is decided by an estimate of its work, from counts and prices, and never by a clock.

use core::cell::Cell;
use core::sync::atomic::{AtomicBool, Ordering};

use crate::stopwatch::{self, Shared};
use crate::tuning::threads::{ENTER_COST, PART_FROM, SECTION_COST};

/// The number of threads that work is cut for.
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

/// Does something that consists of sections and takes about this much `work`, in tenths of a nanosecond.
///
/// If it is much, it is done on a thread of the pool: from there the other threads are woken within microseconds, from outside it takes
/// ten times as long, and each section would wait for it.
pub(crate) fn enter<T: Send>(work: u64, run: impl FnOnce() -> T + Send) -> T {
    #[cfg(feature = "parallel")]
    if is_outside() && gain(work, threads()) >= ENTER_COST {
        return rayon::scope(|_| run());
    }
    let _ = work;
    run()
}

/// How much of some work a thread is spared if it shares it with others.
fn gain(work: u64, threads: usize) -> u64 {
    work - work / threads as u64
}

/// Whether this is no thread of the pool.
fn is_outside() -> bool {
    #[cfg(feature = "parallel")]
    return rayon::current_thread_index().is_none();
    #[cfg(not(feature = "parallel"))]
    return true;
}

/// A part of an update that several threads can share.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Section {
    /// In tenths of a nanosecond on one thread.
    work: u64,
}

impl Section {
    /// A section of `count` items, each of which takes about `price` tenths of a nanosecond on one thread.
    pub(crate) fn of(count: usize, price: u64) -> Self {
        Self {
            work: price.saturating_mul(count as u64),
        }
    }

    /// Into how many parts it is best cut.
    pub(crate) fn parts(self) -> usize {
        let cost = match is_outside() {
            true => ENTER_COST,
            false => SECTION_COST,
        };
        let most = usize::try_from(self.work / PART_FROM).unwrap_or(usize::MAX);
        match threads().min(most) {
            parts if parts > 1 && gain(self.work, parts) >= cost => parts,
            _ => 1,
        }
    }

    /// Calls `work` with each part.
    pub(crate) fn for_each<T: Send>(self, parts: &mut [T], work: impl Fn(&mut T) + Send + Sync) {
        self.run(|| for_each(parts, work));
    }

    /// Does all of it, in one part or in several.
    pub(crate) fn run<T>(self, work: impl FnOnce() -> T) -> T {
        let is_worth_it = gain(self.work, 2) >= SECTION_COST;
        if !is_worth_it || !IS_TIMED.load(Ordering::Relaxed) {
            return work();
        }
        let began = stopwatch::now();
        let done = work();
        let mut shared = SHARED.get();
        shared.time += stopwatch::since(began);
        shared.sections += 1;
        SHARED.set(shared);
        done
    }
}

/// Calls `work` with each part.
fn for_each<T: Send>(parts: &mut [T], work: impl Fn(&mut T) + Send + Sync) {
    #[cfg(feature = "parallel")]
    if parts.len() > 1 && threads() > 1 {
        use rayon::prelude::*;
        parts.par_iter_mut().with_max_len(1).for_each(work);
        return;
    }
    parts.iter_mut().for_each(work);
}

/// Whether anybody wants to know how long sections take.
static IS_TIMED: AtomicBool = AtomicBool::new(false);

thread_local! {
    /// The sections that began on this thread and are worth a second one, whether there is one or not.
    static SHARED: Cell<Shared> = const { Cell::new(Shared::NONE) };
}

/// Has sections timed from now on.
pub(crate) fn time_sections() {
    IS_TIMED.store(true, Ordering::Relaxed);
}

/// The sections so far that began on this thread and that several threads share, or would if there were several; none unless they are
/// [timed](time_sections).
pub(crate) fn shared() -> Shared {
    SHARED.get()
}

/// Runs a test with this number of threads, or with one where there are no others.
#[cfg(test)]
pub(crate) fn with_threads<T: Send>(count: usize, test: impl FnOnce() -> T + Send) -> T {
    #[cfg(feature = "parallel")]
    let run = |test| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(count).build();
        pool.expect("there are threads to be had").install(test)
    };
    #[cfg(feature = "parallel")]
    return run(test);
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

    #[test]
    fn only_what_is_much_is_cut() {
        for threads in [1, 2, 8] {
            with_threads(threads, || {
                let threads = super::threads();
                assert_eq!(Section::of(0, u64::MAX).parts(), 1);
                assert_eq!(Section::of(1, SECTION_COST).parts(), 1);
                assert!((1..=threads).contains(&Section::of(2, SECTION_COST).parts()));
                assert_eq!(Section::of(usize::MAX, u64::MAX).parts(), threads);
            });
        }
    }
}
