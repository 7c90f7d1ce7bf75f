//! Beads with motions of their own, in a box with a zone.

use oorandom::Rand32;
use rapier3d_036::prelude::*;

const RADIUS: f32 = 0.1;

/// Colliders without bodies.
pub(crate) struct Beads {
    pub(crate) colliders: ColliderSet,
    /// The beads, in the order of their velocities, and then the zone.
    pub(crate) handles: Vec<ColliderHandle>,
    velocities: Vec<Vector>,
    /// Half the side of the box.
    reach: f32,
}

impl Beads {
    pub(crate) fn new(count: usize) -> Self {
        // One bead in a cube of three diameters.
        let reach = 3.0 * RADIUS * (count as f32).cbrt();
        let mut random = Rand32::new(36);
        let mut vector =
            |most: f32| Vector::from([(); 3].map(|()| most * (2.0 * random.rand_float() - 1.0)));
        let mut colliders = ColliderSet::new();
        let mut handles = Vec::new();
        let mut velocities = Vec::new();
        for _ in 0..count {
            let bead = ColliderBuilder::ball(RADIUS).translation(vector(reach - RADIUS));
            handles.push(colliders.insert(watched(bead)));
            velocities.push(vector(4.0));
        }
        let zone = ColliderBuilder::cuboid(reach / 3.0, reach / 3.0, reach / 3.0);
        handles.push(colliders.insert(watched(zone)));
        Self {
            colliders,
            handles,
            velocities,
            reach,
        }
    }

    /// Moves every bead, and turns it back at the walls.
    pub(crate) fn fly(&mut self, dt: f32) {
        let most = self.reach - RADIUS;
        for (&handle, velocity) in self.handles.iter().zip(&mut self.velocities) {
            let place = self.colliders[handle].translation() + *velocity * dt;
            let inside = place.clamp(Vector::splat(-most), Vector::splat(most));
            for axis in 0..3 {
                if place[axis] != inside[axis] {
                    velocity[axis] = -velocity[axis];
                }
            }
            self.colliders[handle].set_translation(inside);
        }
    }
}

/// A collider that only notices others. Two colliders without bodies count as fixed, and pairs of fixed colliders are
/// only reported on request.
fn watched(collider: ColliderBuilder) -> ColliderBuilder {
    collider
        .sensor(true)
        .active_collision_types(ActiveCollisionTypes::all())
        .active_events(ActiveEvents::COLLISION_EVENTS)
}
