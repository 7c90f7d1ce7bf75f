//! Shared by all benches: the number of threads, the clock, and whether this is only a smoke test.

#[allow(dead_code, reason = "not every bench drives broad phases")]
mod clock;

/// What updates of so many colliders are timed by. The processor's clock knows nothing of other threads.
#[allow(dead_code, reason = "not every bench drives broad phases")]
pub(crate) fn clock_for(count: usize) -> clock::Clock {
    if rayon::current_num_threads() > 1 {
        return clock::Clock::Wall;
    }
    clock::Clock::for_count(count)
}

/// One thread, unless `RAYON_NUM_THREADS` says otherwise.
pub(crate) fn set_threads() {
    if std::env::var_os("RAYON_NUM_THREADS").is_none() {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1);
        pool.build_global().expect("no pool was made before");
    }
}

/// Whether every bench runs only once, without measuring: with `--test`, or without the `--bench` that
/// `cargo bench` adds. The largest inputs, which take seconds to build, are then left out.
pub(crate) fn is_smoke_test() -> bool {
    let given = |flag| std::env::args().any(|argument| argument == flag);
    given("--test") || !given("--bench")
}
