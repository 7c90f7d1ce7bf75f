//! Ropes of jointed capsules that fall over bars and knot.
//!
//! ```text
//! cargo run --release --features rapier3d --example rope3d -- --out rope3d.gif
//! ```

use rapier3d as rapier;
use unisize::rapier3d as ours;
use unisize_scenes::dim3 as scenes;

mod ropes;
#[path = "../show/mod.rs"]
mod show;
#[path = "../show/solids.rs"]
mod solids;

use ropes::Ropes;
use std::process::ExitCode;

fn main() -> ExitCode {
    show::run::<Ropes>()
}
