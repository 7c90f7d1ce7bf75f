//! What all benches share: on how many threads they run, and whether they measure at all.

/// One thread, unless `RAYON_NUM_THREADS` says otherwise.
pub(crate) fn set_threads() {
    if std::env::var_os("RAYON_NUM_THREADS").is_none() {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1);
        pool.build_global().expect("no pool was made before");
    }
}

/// Whether every bench only runs once, to see that it does: with `--test`, and without the `--bench` that
/// `cargo bench` adds. The largest inputs, which take seconds to build, are left out then.
pub(crate) fn is_smoke_test() -> bool {
    let given = |flag| std::env::args().any(|argument| argument == flag);
    given("--test") || !given("--bench")
}
