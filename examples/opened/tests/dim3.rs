//! What only Rapier 0.36 has, and spells differently in three dimensions.

use super::rapier::prelude::*;

/// A cube of this half side.
pub(super) fn soft_body(centre: Vector, half: Real) -> SoftBodyBuilder {
    SoftBodyBuilder::cuboid(centre, Vector::splat(half), 4, 4, 4)
}
