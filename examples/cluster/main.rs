//! Boxes in a plane that all fly through its centre: the last experiment of Capannini and Larsson (section 5).
//!
//! ```text
//! cargo run --release --features rapier3d --example cluster -- --out cluster.gif
//! ```

use rapier3d as rapier;
use unisize::rapier3d as ours;
use unisize_scenes::dim3 as scenes;

mod implosion;
#[path = "../show/mod.rs"]
mod show;

use implosion::Implosion;
use std::process::ExitCode;

fn main() -> ExitCode {
    show::run::<Implosion>()
}
