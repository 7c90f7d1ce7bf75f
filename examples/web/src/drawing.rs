//! The arrays of numbers that a graphics card draws: bodies of a few shapes, and lines.

use crate::engine::World;
use crate::rapier::math::{DIM, Real};
use crate::rapier::parry::shape::TypedShape;
use crate::rapier::prelude::*;
use crate::version::{self, Pose, Vector};

/// The half width and half thickness of the slab that is drawn for a half-space.
pub(crate) const SLAB: [Real; 2] = [1000.0, 0.05];

/// All bodies of one shape: see `Side::batch_shape` and the methods after it.
pub(crate) struct Batch {
    pub(crate) shape: &'static str,
    pub(crate) length: f32,
    pub(crate) places: Vec<f32>,
}

/// Draws all colliders. Batches stay, even if they are empty, so that the page can keep its buffers for them.
pub(crate) fn draw(world: &World, batches: &mut Vec<Batch>) {
    batches.iter_mut().for_each(|batch| batch.places.clear());
    for (handle, collider) in world.colliders.iter() {
        let body = collider.parent().map(|parent| &world.bodies[parent]);
        let is_fixed = body.is_none_or(|body| body.is_fixed());
        let is_asleep = body.is_some_and(|body| body.is_sleeping());
        // Neighbours differ in brightness, so that their borders show.
        let variety = handle.into_raw_parts().0.wrapping_mul(0x9e37_79b9) >> 24;
        let shade = if is_asleep {
            0.3
        } else {
            0.7 + variety as f32 / 850.0
        };
        let (shape, length, half) = outline(collider, is_fixed);
        let mut same = batches.iter();
        let index = same.position(|batch| (batch.shape, batch.length) == (shape, length));
        let index = index.unwrap_or_else(|| {
            let places = Vec::new();
            batches.push(Batch {
                shape,
                length,
                places,
            });
            batches.len() - 1
        });
        let pose: Pose = *collider.position();
        let places = &mut batches[index].places;
        for [x, y, z] in axes(&pose, half) {
            places.extend([x, y, z, 0.0]);
        }
        let [x, y, z] = spatial(version::translation(&pose));
        places.extend([x, y, z, shade]);
    }
}

/// The shape of a collider, the length of its straight part, and the scale along each axis.
fn outline(collider: &Collider, is_fixed: bool) -> (&'static str, f32, [Real; 3]) {
    match collider.shape().as_typed_shape() {
        TypedShape::Ball(ball) => (
            ["ball", "rock"][usize::from(is_fixed)],
            0.0,
            [ball.radius; 3],
        ),
        TypedShape::Capsule(capsule) => {
            let length = 2.0 * capsule.half_height() / capsule.radius;
            ("capsule", length, [capsule.radius; 3])
        }
        TypedShape::HalfSpace(_) => ("wall", 0.0, [SLAB[0], SLAB[1], SLAB[0]]),
        TypedShape::Cuboid(cuboid) => {
            let shape = ["cuboid", "wall"][usize::from(is_fixed)];
            (shape, 0.0, spatial(cuboid.half_extents))
        }
        _ => (
            "cuboid",
            0.0,
            spatial(collider.compute_aabb().half_extents()),
        ),
    }
}

/// The images of the unit vectors, scaled.
fn axes(pose: &Pose, half: [Real; 3]) -> [[f32; 3]; 3] {
    let mut axes = [[0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    for axis in 0..DIM {
        let mut unit = Vector::default();
        unit[axis] = half[axis];
        axes[axis] = spatial(pose.rotation * unit);
    }
    axes
}

/// A vector with three coordinates; the third is 0 in 2D.
fn spatial(vector: Vector) -> [f32; 3] {
    std::array::from_fn(|axis| if axis < DIM { vector[axis] } else { 0.0 })
}

/// The mins and maxs of a box, with three coordinates each.
pub(crate) fn corners(aabb: &Aabb) -> [f32; 6] {
    std::array::from_fn(|index| match (index % 3, index / 3) {
        (axis, _) if axis >= DIM => 0.0,
        (axis, 0) => aabb.mins[axis],
        (axis, _) => aabb.maxs[axis],
    })
}

/// The ends of all edges of a box.
pub(crate) fn edges(aabb: &Aabb) -> impl Iterator<Item = f32> + use<> {
    let corners = corners(aabb);
    // Bit k of a corner says whether it is at the maxs of axis k. An edge along axis k starts at a corner whose bit k is 0.
    let starts = (0..1 << DIM).flat_map(|corner| (0..DIM).map(move |axis| (corner, 1 << axis)));
    let edges = starts.filter(|(corner, axis)| corner & axis == 0);
    let ends = edges.flat_map(|(corner, axis)| [corner, corner | axis]);
    ends.flat_map(move |corner: usize| {
        (0..3).map(move |axis| corners[axis + 3 * (corner >> axis & 1)])
    })
}

/// The ends of the line between two colliders: their centres, or the nearest point of the box of one without a body.
pub(crate) fn ends(pair: [&Collider; 2]) -> [f32; 6] {
    let boxes = pair.map(|collider| corners(&collider.compute_aabb()));
    let center = |side: usize, axis: usize| f32::midpoint(boxes[side][axis], boxes[side][axis + 3]);
    std::array::from_fn(|index| {
        let (side, axis) = (index / 3, index % 3);
        match pair[side].parent() {
            Some(_) => center(side, axis),
            // Not `clamp`, which would panic on an inverted box.
            None => {
                let nearest = center(1 - side, axis).max(boxes[side][axis]);
                nearest.min(boxes[side][axis + 3])
            }
        }
    })
}
