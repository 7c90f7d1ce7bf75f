//! A stampede through a gorge: animals avoid each other and rocks.
//!
//! The broad phase is the neighbour search: the box of an animal covers what it sees, and its neighbours are those with which
//! it forms a pair.
//!
//! ```text
//! cargo run --release --features rapier2d-027 --example crowd2d -- --out crowd2d.gif
//! ```

use unisize::rapier2d_027 as ours;
use unisize_scenes::dim2 as scenes;

#[path = "show/gorge.rs"]
mod gorge;
#[path = "show/mod.rs"]
mod show;

use std::process::ExitCode;

fn main() -> ExitCode {
    show::run::<gorge::Gorge>()
}
