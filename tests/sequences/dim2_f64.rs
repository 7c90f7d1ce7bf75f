//! The suite for rapier2d-f64.

use rapier2d_f64 as rapier;
use unisize::rapier2d_f64::{Kernel, Settings, UnisizeBroadPhase};

#[path = "suite/mod.rs"]
mod suite;

#[path = "rapier_0_27/mod.rs"]
mod version;

pub(crate) use suite::play;
