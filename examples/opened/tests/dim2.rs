//! What only Rapier 0.36 has, and spells differently in two dimensions.

use super::rapier::prelude::*;

/// A disk of this radius.
pub(super) fn soft_body(centre: Vector, radius: Real) -> SoftBodyBuilder {
    SoftBodyBuilder::disk(centre, radius, 24)
}
