//! What all benches share: how long they measure, and whether they measure at all.

use criterion::Criterion;
use std::time::Duration;

/// Ten short samples a figure, so that a whole bench takes a few minutes; arguments on the command line
/// come before this.
pub(crate) fn criterion() -> Criterion {
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
