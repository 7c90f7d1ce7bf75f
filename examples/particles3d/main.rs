//! Grains that are poured into a container, colour after colour.
//!
//! ```text
//! cargo run --release --features rapier3d --example particles3d -- --out particles3d.gif
//! ```

use rapier3d as rapier;
use unisize::rapier3d as ours;
use unisize_scenes::dim3 as scenes;

mod pour;
#[path = "../show/mod.rs"]
mod show;
#[path = "../show/solids.rs"]
mod solids;

use pour::Pour;
use std::process::ExitCode;

fn main() -> ExitCode {
    show::run::<Pour>()
}
