//! The soft body of the scenes, in versions of Rapier that have them.

use super::engine::space::Vector;
use super::rapier::prelude::*;

/// A cube of this half side.
pub(super) fn soft_body(center: Vector, half: Real) -> SoftBodyBuilder {
    SoftBodyBuilder::cuboid(center, Vector::splat(half), 3, 3, 3)
}
