//! Boxes in a plane all fly through its centre: the last experiment of Capannini and Larsson (section 5).
//!
//! ```text
//! cargo run --release --features rapier3d-027 --example cluster -- --out cluster.gif
//! ```

use unisize::rapier3d_027 as ours;
use unisize_scenes::dim3 as scenes;

#[path = "show/implosion.rs"]
mod implosion;
#[path = "show/mod.rs"]
mod show;

use std::process::ExitCode;

fn main() -> ExitCode {
    show::run::<implosion::Implosion>()
}
