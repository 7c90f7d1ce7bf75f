//! Shows the scenes of the examples live, in a window, with either broad phase or both.
//!
//! ```text
//! cargo run --release -- --scene rope3d
//! ```
//!
//! A [`stage::Stage`] is a scene with its broad phases. What knows an engine is in the folder `dimension`, and is compiled once
//! for each dimension; everything else knows none. What is seen is what the scene would draw into its film.

mod camera;
mod chart;
#[path = "../../show/choice.rs"]
mod choice;
mod dim2;
mod dim3;
mod figures;
mod history;
mod lines;
mod options;
mod panel;
mod setup;
mod stage;
mod viewer;
mod window;

use clap::Parser;
use options::Options;
use std::process::ExitCode;

fn main() -> ExitCode {
    match viewer::run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(2)
        }
    }
}
