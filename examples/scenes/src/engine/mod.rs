//! The part of the scenes that touches Rapier: one source for every flavour.

use super::{flavour, rapier, vehicle, version};

mod comparison;
mod container;
mod lattice;
mod lossy;
mod observed;
mod queries;
mod sanity;
mod scene;
mod scenes;
mod script;
pub(super) mod space;
mod stage;
mod world;

pub use comparison::{Both, Candidate, Clocked, Comparison, Independent, Outcome, RayCount, Tally};
pub use lossy::Lossy;
pub use observed::{Observed, PairEvent, Tee, Timing, Update};
pub use queries::{Queries, QueryAccess};
pub use sanity::Sanity;
pub use scene::Scene;
pub use world::World;
