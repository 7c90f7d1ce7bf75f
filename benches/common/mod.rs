//! What all benches share: how long they measure, and whether they measure at all.

use criterion::Criterion;
use std::time::Duration;

/// Ten short samples a figure, so that a whole bench takes a few minutes; arguments on the command line
/// come before this. One thread, unless `RAYON_NUM_THREADS` says otherwise.
pub(crate) fn criterion() -> Criterion {
    if std::env::var_os("RAYON_NUM_THREADS").is_none() {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1);
        pool.build_global().expect("no pool was made before");
    }
    Criterion::default()
        .without_plots()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(200))
        .measurement_time(Duration::from_millis(600))
        .configure_from_args()
}

/// Whether every bench only runs once, to see that it does: with `--test`, and without the `--bench` that
/// `cargo bench` adds. The largest inputs, which take seconds to build, are left out then.
pub(crate) fn is_smoke_test() -> bool {
    let given = |flag| std::env::args().any(|argument| argument == flag);
    given("--test") || !given("--bench")
}
