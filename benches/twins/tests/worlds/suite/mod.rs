//! The tests: one source for both versions of Rapier and every flavour, which the module that includes it names as `rapier`.

use super::rapier;
use super::scenes;
use super::version;
use super::{Installed, Observed, OwnBroadPhase, PairFilter, Settings, Steppable, Trial};
use super::{UnisizeBroadPhase, World, install};
use super::{hinge, mesh_floor};
use crate::cases::cases;

mod bullets;
mod changes;
mod characters;
mod collisions;
mod filters;
mod hooks;
mod joints;
mod odd_numbers;
pub(super) mod ordered;
mod queries;
pub(super) mod random;
mod random_worlds;
mod removals;
mod rollback;
mod ships;
pub(super) mod snapshot;
mod trial;
pub(super) mod twins;
mod upheavals;
mod wake_ups;
mod worlds;
