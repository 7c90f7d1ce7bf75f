//! The tests: one source for every flavour, which the module that includes it names as `rapier`.

use super::rapier;
use super::{Settings, UnisizeBroadPhase, World, height_field, hinge, mesh_floor, spin};

mod bullets;
mod changes;
mod choices;
mod collisions;
mod filters;
mod floors;
mod hostile;
mod odd_updates;
mod piles;
mod queries;
mod removals;
mod snapshot;
mod twins;
mod wake_ups;
