//! The scene in two dimensions.

use rapier2d as rapier;
use unisize::rapier2d as ours;
use unisize_scenes::dim2 as scenes;

#[path = "dimension/live.rs"]
mod live;
#[path = "dimension/show.rs"]
mod show;
#[path = "../../crowd2d/stampede.rs"]
mod stampede;

pub(crate) use live::Live;
pub(crate) use stampede::Stampede;
