//! What a scene asks for, as in `examples/show`, but with a broad phase that can be replaced while it works.

#[path = "../../../show/contract.rs"]
#[allow(
    dead_code,
    reason = "some of it is about films, of which there are none here"
)]
mod contract;
#[path = "../../../show/side.rs"]
mod side;
mod watched;

pub(crate) use contract::Show;
pub(crate) use watched::Watched;

use super::{ours, rapier, scenes};
