//! Grains are poured into a container, colour after colour.
//!
//! ```text
//! cargo run --release --features rapier3d-027 --example particles3d -- --out particles3d.gif
//! ```

use unisize::rapier3d_027 as ours;
use unisize_scenes::dim3 as scenes;

#[path = "show/pour.rs"]
mod pour;
#[path = "show/mod.rs"]
mod show;

use std::process::ExitCode;

fn main() -> ExitCode {
    show::run::<pour::Pour>()
}
