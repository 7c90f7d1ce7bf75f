//! Rotations and normals that are not of unit length: those that a file has rounded, and those that another engine has not normalized.

use super::super::rapier::prelude::*;
use super::super::scenes::along;
use super::super::twins::cuboid;
use super::super::version;
use super::Playground;

/// The lengths of rotations.
const NORMS: [Real; 8] = [0.9, 0.95, 0.99, 0.9999, 1.0001, 1.01, 1.05, 1.1];

impl Playground {
    /// Inserts two half-spaces that face each other.
    pub(super) fn insert_half_spaces(&mut self) {
        for side in [-1.0, 1.0] {
            let body = RigidBodyBuilder::fixed().translation(along(1, 2.0 * side));
            let length = self.random.pick(&[0.1, 0.5, 1.0, 2.0, 10.0]);
            let plane = SharedShape::halfspace(version::unit(along(1, -side)));
            let plane = version::stretched_half_space(plane, length);
            let collider = ColliderBuilder::new(plane).solver_groups(InteractionGroups::none());
            self.twins.insert(body, collider);
        }
    }

    pub(super) fn turn(&mut self) {
        let norm = self.random.pick(&NORMS);
        let rotation = version::stretched(self.random.pose(), norm).rotation;
        let long = self.random.pick(&[0.3, 1.0, 2.0]);
        let [start, end] = [0.0, long].map(|y| along(1, y).into());
        let shape = match self.random.below(4) {
            0 => SharedShape::capsule_y(long, 0.1),
            1 => SharedShape::capsule(start, end, 0.1),
            2 => SharedShape::segment(start, end),
            _ => cuboid([0.1, long, 0.2]).shape,
        };
        match self.random.below(4) {
            0 | 1 => self.change_body(|body| body.set_rotation(rotation, true)),
            2 => self.change(|it| {
                let mut place = *it.position_wrt_parent().expect("all are on bodies");
                place.rotation = rotation;
                it.set_position_wrt_parent(place);
            }),
            _ => self.change(|it| it.set_shape(shape.clone())),
        }
    }
}
