//! The tests: one source for both dimensions, which the module that includes it names as `rapier`.

use super::rapier;
use super::{PairFilter, Settings, UnisizeBroadPhase, floors, hinge, soft_body, spin};

mod bullets;
mod changes;
mod characters;
mod exchange;
mod filters;
mod hostile;
mod joints;
mod misuse;
mod piles;
mod queries;
mod recycling;
mod removals;
mod snapshot;
mod soft_bodies;
pub(super) mod twins;
