//! The soft body of the scenes, in versions of Rapier that have them.

use super::engine::space::Vector;
use super::rapier::prelude::*;

/// A disk of this radius.
pub(super) fn soft_body(center: Vector, radius: Real) -> SoftBodyBuilder {
    SoftBodyBuilder::disk(center, radius, 16)
}
