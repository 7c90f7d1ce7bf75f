//! The tests: one source for every flavour, which the module that includes it names as `rapier`.

use super::rapier;
use super::{
    PairFilter, Settings, Tee, UnisizeBroadPhase, World, height_field, hinge, mesh_floor, spin,
};

mod answers;
mod bullets;
mod changes;
mod characters;
mod choices;
mod collisions;
mod debug_render;
mod exchange;
mod filter_levels;
mod filters;
mod floors;
mod hostile;
mod inquiries;
mod odd_updates;
mod piles;
mod queries;
mod removals;
mod snapshot;
pub(super) mod twins;
mod wake_ups;
mod watched;
