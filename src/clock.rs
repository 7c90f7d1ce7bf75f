//! The wall clock.

use std::time::{Duration, Instant};

/// The time, if there is a clock. WebAssembly without an operating system has none, and reading it would panic.
pub(crate) fn now() -> Option<Instant> {
    const IS_CLOCK: bool = !cfg!(all(target_family = "wasm", target_os = "unknown"));
    IS_CLOCK.then(Instant::now)
}

/// The time since then; zero without a clock.
pub(crate) fn since(began: Option<Instant>) -> Duration {
    began.map_or(Duration::ZERO, |began| began.elapsed())
}
