//! The part of the scenes that touches Rapier: one source for every flavour.

use super::{flavour, rapier, vehicle, version};

mod comparison;
mod container;
mod lattice;
mod lossy;
mod observed;
mod pairs;
pub(super) mod queries;
mod sanity;
mod scene;
mod scenes;
mod script;
mod seldom;
pub(super) mod space;
mod stage;
mod world;

pub use comparison::{Candidate, Comparison};
pub use lossy::lossy;
pub use observed::{Observed, Tee, Update};
pub use pairs::PairEvent;
pub use queries::AsQueryPipeline;
pub use sanity::Sanity;
pub use scene::Scene;
pub use seldom::Seldom;
pub use space::{along, length, own, vector};
pub use world::{Steppable, World};
