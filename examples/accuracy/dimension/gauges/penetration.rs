//! How far bodies are in each other, by Parry's exact queries of all shapes whose boxes overlap: what a broad phase loses is
//! seen all the same.

use super::scenes::rapier::{
    parry::{bounding_volume::BoundingVolume, query},
    prelude::*,
};
use super::{Gauge, Reading, Tally, World};

/// The depth of overlaps, in sizes of a body: the largest, and the mean.
///
/// The mean is over the pairs that overlap, at all looks, and not over all pairs or bodies. So it does not grow with the number of
/// overlaps, and can fall if more pairs overlap a little.
pub(crate) struct Penetration {
    size: f64,
    from: f64,
    depths: Tally,
}

impl Penetration {
    /// For bodies of this size, from this time on.
    pub(crate) fn new(size: f64, from: f64) -> Self {
        Self {
            size,
            from,
            depths: Tally::default(),
        }
    }
}

impl Gauge for Penetration {
    fn look(&mut self, world: &World, time: f64) {
        if time <= self.from {
            return;
        }
        for depth in depths(world) {
            self.depths.add(depth / self.size);
        }
    }

    fn read(&self) -> Vec<Reading> {
        vec![
            Reading {
                name: "largest penetration, sizes",
                value: self.depths.largest,
            },
            Reading {
                name: "mean penetration, sizes",
                value: self.depths.mean(),
            },
        ]
    }
}

/// The depths of all pairs that overlap and may not. Each box is compared with each.
fn depths(world: &World) -> Vec<f64> {
    let colliders: Vec<_> = world
        .colliders
        .iter_enabled()
        .map(|(_, collider)| (collider.compute_aabb(), collider))
        .collect();
    let mut depths = Vec::new();
    for (index, (aabb, a)) in colliders.iter().enumerate() {
        for (other, b) in &colliders[..index] {
            if !aabb.intersects(other) || !may_touch(world, a, b) {
                continue;
            }
            let contact = query::contact(a.position(), a.shape(), b.position(), b.shape(), 0.0);
            let contact = contact.expect("the shapes of the stages are supported");
            depths.extend(contact.map(|contact| f64::from(-contact.dist).max(0.0)));
        }
    }
    depths
}

/// Whether two colliders should push each other apart: some joints say that they should not.
fn may_touch(world: &World, a: &Collider, b: &Collider) -> bool {
    let are_joined = a.parent().zip(b.parent()).is_some_and(|(a, b)| {
        let mut joints = world.impulse_joints.joints_between(a, b);
        joints.any(|(_, joint)| !joint.data.contacts_enabled)
    });
    !are_joined && world.may_touch(a, b)
}
