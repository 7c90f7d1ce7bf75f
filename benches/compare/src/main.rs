//! The program for Rapier 0.27; `lib.rs` says what it does.

fn main() -> std::process::ExitCode {
    compare::run()
}
