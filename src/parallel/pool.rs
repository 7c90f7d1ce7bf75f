//! Threads on which no job runs but parts of unisize's own work.
//!
//! A thread of a Rayon pool that waits runs other jobs of its pool meanwhile. If those were the caller's, one of them could wait for a
//! mutex that the caller of the step holds, and that it does not release before the step ends. So unisize shares work in pools of its own.
//! Each of them has one update at a time, which therefore waits for no other update either.

use std::cell::Cell;
use std::collections::BTreeMap;
use std::panic::resume_unwind;
use std::sync::{Mutex, PoisonError, TryLockError};
use std::thread;

use rayon::{ThreadPool, ThreadPoolBuilder};

/// The pools that have started, by their numbers of threads.
static POOLS: Mutex<BTreeMap<usize, &Mutex<ThreadPool>>> = Mutex::new(BTreeMap::new());

thread_local! {
    static IS_INSIDE: Cell<bool> = const { Cell::new(false) };
}

/// Whether the current thread belongs to a pool of unisize's own.
pub(super) fn is_inside() -> bool {
    IS_INSIDE.get()
}

/// Starts a pool.
pub(super) fn start(threads: usize) -> Option<ThreadPool> {
    let builder = ThreadPoolBuilder::new().num_threads(threads);
    let builder = builder.thread_name(|i| format!("unisize-{i}"));
    builder.start_handler(|_| IS_INSIDE.set(true)).build().ok()
}

/// The pool with this number of threads, which starts if it has not. There is none if one thread is enough, or no more are to be had.
fn pool(threads: usize) -> Option<&'static Mutex<ThreadPool>> {
    if threads == 1 {
        return None;
    }
    let mut pools = POOLS.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(pool) = pools.get(&threads) {
        return Some(pool);
    }
    let pool = Box::leak(Box::new(Mutex::new(start(threads)?)));
    pools.insert(threads, pool);
    Some(pool)
}

/// Runs a function in the pool that has as many threads as the caller's; on the current thread if another update has that pool.
pub(super) fn run<T: Send>(run: impl FnOnce() -> T + Send) -> T {
    let Some(pool) = pool(rayon::current_num_threads()) else {
        return run();
    };
    let pool = match pool.try_lock() {
        Ok(pool) => pool,
        // An update has panicked, not the pool.
        Err(TryLockError::Poisoned(poisoned)) => poisoned.into_inner(),
        Err(TryLockError::WouldBlock) => return run(),
    };
    if rayon::current_thread_index().is_none() {
        return pool.install(run);
    }
    // A thread of the caller's pool would run other jobs while it waits for another pool. So another thread waits for that, and this one
    // for the other thread.
    let (mut run, mut done) = (Some(run), None);
    thread::scope(|scope| {
        let install = || done = run.take().map(|run| pool.install(run));
        let waiting = thread::Builder::new().spawn_scoped(scope, install);
        if let Ok(Err(panic)) = waiting.map(|waiting| waiting.join()) {
            resume_unwind(panic);
        }
    });
    // Without another thread, nothing has run.
    done.unwrap_or_else(|| run.expect("it has not run")())
}

#[cfg(test)]
mod tests {
    use super::super::{Section, enter, join, threads};
    use super::*;
    use std::panic::{AssertUnwindSafe, catch_unwind};
    use std::sync::atomic::{AtomicUsize, Ordering};
    use std::thread::{ThreadId, current};
    use std::time::{Duration, Instant};

    /// A pool of the caller's, of a size that no other test has.
    fn callers(threads: usize) -> ThreadPool {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build();
        pool.expect("there are threads to be had")
    }

    #[test]
    fn much_work_has_as_many_threads_as_the_callers_pool() {
        callers(17).install(|| {
            assert_eq!([0, 1000].map(|work| enter(work, threads)), [1, 1]);
            assert_eq!(enter(u64::MAX, threads), 17);
            assert_eq!(enter(u64::MAX, || enter(u64::MAX, threads)), 17);
            assert_eq!(threads(), 1);
        });
        assert_eq!(callers(1).install(|| enter(u64::MAX, threads)), 1);
        // Other tests have this pool by turns.
        let all = rayon::current_num_threads();
        assert!((0..10_000).any(|_| {
            thread::sleep(Duration::from_millis(1));
            enter(u64::MAX, threads) == all
        }));
    }

    /// Returns the threads that run two parts of a section at once, and those of a join.
    fn sharing() -> [[ThreadId; 2]; 2] {
        let (arrived, began) = (AtomicUsize::new(0), Instant::now());
        let id = || {
            arrived.fetch_add(1, Ordering::SeqCst);
            // The other one comes at once, or never.
            while arrived.load(Ordering::SeqCst) % 2 == 1 && began.elapsed().as_secs() < 60 {
                thread::yield_now();
            }
            current().id()
        };
        let mut ids = [current().id(); 2];
        Section::of(2, 1 << 40).for_each(&mut ids, |part| *part = id());
        [ids, enter(u64::MAX, || join(id, id).into())]
    }

    #[test]
    fn parts_run_at_once_and_not_on_the_callers_threads() {
        for ids in callers(19).install(|| {
            let own = current().id();
            sharing().map(|ids| [own, ids[0], ids[1]])
        }) {
            assert!(ids[0] != ids[1] && ids[0] != ids[2] && ids[1] != ids[2]);
        }
    }

    #[test]
    fn an_update_does_not_wait_for_another() {
        let (callers, parts) = (callers(21), &mut [0; 2]);
        let others = callers.install(|| {
            enter(u64::MAX, || {
                let other = || {
                    // Much work, in a section that begins outside.
                    Section::of(2, 1 << 40).for_each(parts, |part| *part = threads());
                    enter(u64::MAX, threads)
                };
                let other = || callers.install(other);
                thread::scope(|scope| scope.spawn(other).join())
            })
        });
        assert_eq!((others.expect("no panic"), *parts), (1, [1; 2]));
    }

    #[test]
    fn panics_pass_and_leave_the_pool_as_it_is() {
        for is_worker in [true, false] {
            let panics = || enter(u64::MAX, || std::panic::panic_any(7));
            let panics = || catch_unwind(AssertUnwindSafe(panics));
            let callers = callers(23);
            let panic = match is_worker {
                true => callers.install(panics),
                false => panics(),
            };
            assert_eq!(panic.unwrap_err().downcast_ref(), Some(&7));
            assert_eq!(callers.install(|| enter(u64::MAX, threads)), 23);
        }
    }
}
