//! The scenes in three dimensions.

use rapier3d as rapier;
use unisize::rapier3d as ours;
use unisize_scenes::dim3 as scenes;

#[path = "../../cluster/implosion.rs"]
mod implosion;
#[path = "dimension/live.rs"]
mod live;
#[path = "../../particles3d/pour.rs"]
mod pour;
#[path = "../../rope3d/ropes.rs"]
mod ropes;
#[path = "dimension/show.rs"]
mod show;
#[path = "../../show/solids.rs"]
mod solids;
#[cfg(test)]
mod tests;

pub(crate) use implosion::Implosion;
pub(crate) use live::Live;
pub(crate) use pour::Pour;
pub(crate) use ropes::Ropes;
