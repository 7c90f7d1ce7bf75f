//! The vehicle of the plane: there is none, for Rapier's controller of vehicles needs a third dimension.

use super::engine::World;
use super::engine::space::Vector;
use super::rapier::parry::partitioning::Bvh;
use super::rapier::prelude::*;

/// A vehicle, of which there is none.
#[derive(Clone)]
pub(super) enum Vehicle {}

impl Vehicle {
    /// Inserts no vehicle.
    pub(super) fn insert(_world: &mut World, _place: Vector) -> Option<Self> {
        None
    }

    /// Drives the vehicle.
    pub(super) fn drive(&mut self, _step: usize, _world: &mut World, _tree: &Bvh) -> Real {
        match *self {}
    }
}
