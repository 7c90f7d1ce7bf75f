//! Grains are poured through a funnel.
//!
//! ```text
//! cargo run --release --features rapier3d-027 --example particles3d -- --verify-pairs
//! ```

use unisize::rapier3d_027::UnisizeBroadPhase;
use unisize_scenes::{SceneKind, dim3 as scenes};

#[path = "show/options.rs"]
mod options;
#[path = "show/run.rs"]
mod run;

fn main() -> std::process::ExitCode {
    run::run(SceneKind::Hopper)
}
