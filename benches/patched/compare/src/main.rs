//! Does unisize do the same as Rapier 0.36's own broad phase in its own pipelines, and how much faster does it make a step?
//!
//! ```text
//! cargo run --release --package compare-patched -- --quick
//! ```
//!
//! The same program as `benches/compare`, which says what is compared, on a patched copy of Rapier. The broad phase is timed
//! where the copy calls it, in `update` and in `set_aabbs`, alike for both. Rapier's own optimizes its tree between the two,
//! next to the solver if it has threads; there it is timed as a part of the next update. Whole steps are Rapier as it is.
//!
//! With the feature `parallel`, Rapier and unisize share the threads that `--threads` asks for.

fn main() -> std::process::ExitCode {
    compare::run()
}
