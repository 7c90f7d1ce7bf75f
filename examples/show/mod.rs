//! What the examples that show a world have in common: the command line, a broad phase that is timed and checked, and a film.
//! They include this folder as a module.
//!
//! It is compiled once per example, with the unisize and the scenes of one dimension, which the example calls `ours` and
//! `scenes`. Bodies, pairs and pictures are the same in each run; times are not.

mod choice;
mod difference;
mod film;
mod options;
#[path = "../progress/bar.rs"]
mod progress;
mod rivals;
mod run;
mod world;

pub(crate) use run::run;
pub(crate) use world::{HeldPairs, Show};

use crate::{ours, scenes, show};
use scenes::rapier;
