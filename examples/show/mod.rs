//! What the examples that show something have in common: the same switches, a broad phase that is watched while it works,
//! and a film of what happens. They include this folder as a module.
//!
//! It is compiled once per example, with the Rapier that the example calls `rapier`, the unisize for it, `ours`, and the
//! scenes for it, `scenes`. Bodies, pairs and pictures are the same in each run, times are not.

mod choice;
mod contract;
mod film;
mod options;
#[path = "../progress/bar.rs"]
mod progress;
mod run;
mod side;
mod watched;

pub(crate) use contract::Show;
pub(crate) use run::run;
pub(crate) use watched::Watched;

use crate::{ours, rapier, scenes};
