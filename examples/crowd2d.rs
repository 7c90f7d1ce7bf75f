//! Walkers on a plane, each on its way to a goal: a pair is two that may get in each other's way.
//!
//! ```text
//! cargo run --release --features rapier2d-027 --example crowd2d -- --verify-pairs
//! ```

use unisize::rapier2d_027::UnisizeBroadPhase;
use unisize_scenes::{SceneKind, dim2 as scenes};

#[path = "show/options.rs"]
mod options;
#[path = "show/run.rs"]
mod run;

fn main() -> std::process::ExitCode {
    run::run(SceneKind::Crowd)
}
