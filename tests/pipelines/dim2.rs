//! The suite for rapier2d, and what Rapier spells differently in two dimensions.

use rapier::na::DVector;
use rapier::prelude::*;
use rapier2d as rapier;
use unisize::rapier2d::UnisizeBroadPhase;
use unisize_scenes::dim2::World;

#[path = "suite/mod.rs"]
mod suite;

/// A floor at height 0 of this half width, made of segments.
fn mesh_floor(half: Real) -> ColliderBuilder {
    ColliderBuilder::polyline(vec![point![-half, 0.0], point![half, 0.0]], None)
}

/// A floor at height 0 of this half width, as a height field.
fn height_field(half: Real) -> ColliderBuilder {
    ColliderBuilder::heightfield(DVector::zeros(9), vector![2.0 * half, 1.0])
}

/// A hinge.
fn hinge() -> RevoluteJointBuilder {
    RevoluteJointBuilder::new()
}

/// A spin of this many radians per second.
fn spin(speed: Real) -> AngVector<Real> {
    speed
}
