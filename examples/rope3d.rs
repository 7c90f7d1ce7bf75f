//! Ropes of jointed capsules fall over bars and tangle.
//!
//! ```text
//! cargo run --release --features rapier3d-027 --example rope3d -- --out rope3d.gif
//! ```

use unisize::rapier3d_027 as ours;
use unisize_scenes::dim3 as scenes;

#[path = "show/ropes.rs"]
mod ropes;
#[path = "show/mod.rs"]
mod show;

use std::process::ExitCode;

fn main() -> ExitCode {
    show::run::<ropes::Ropes>()
}
