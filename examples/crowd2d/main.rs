//! A stampede through a gorge: animals that make room for each other, and for rocks.
//!
//! The broad phase does all the looking: the box of an animal is as large as what it sees, and its neighbours are those
//! with which it is a pair.
//!
//! ```text
//! cargo run --release --features rapier2d --example crowd2d -- --out crowd2d.gif
//! ```

use rapier2d as rapier;
use unisize::rapier2d as ours;
use unisize_scenes::dim2 as scenes;

#[path = "../show/mod.rs"]
mod show;
mod stampede;

use stampede::Stampede;
use std::process::ExitCode;

fn main() -> ExitCode {
    show::run::<Stampede>()
}
