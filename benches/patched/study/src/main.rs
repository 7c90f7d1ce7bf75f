//! Studies of what unisize does to a simulation in Rapier 0.36.
//!
//! ```text
//! cargo run --release --package study-patched -- stability
//! ```
//!
//! The same program as `benches/study`, which says what is studied, on a patched copy of Rapier.

fn main() -> std::process::ExitCode {
    study::run()
}
