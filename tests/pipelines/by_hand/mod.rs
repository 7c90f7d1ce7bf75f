//! Single updates with lists made by hand, in every version of Rapier, opened or not.

use super::rapier::{self, prelude::*};
use super::{PairFilter, Settings, UnisizeBroadPhase};
pub(super) use desk::Desk;

mod choices;
#[path = "../../desk/mod.rs"]
mod desk;
mod hostile;
