//! The studies of Rapier 0.27; `lib.rs` says what they are.

fn main() -> std::process::ExitCode {
    study::run()
}
