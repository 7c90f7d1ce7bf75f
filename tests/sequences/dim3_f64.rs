//! The suite for rapier3d-f64.

use rapier3d_f64 as rapier;
use unisize::rapier3d_f64::{Kernel, Settings, UnisizeBroadPhase};

#[path = "suite/mod.rs"]
mod suite;

#[path = "rapier_0_27/mod.rs"]
mod version;

pub(crate) use suite::play;
