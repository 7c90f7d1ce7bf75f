//! A scene on one broad phase: one source for every flavour of Rapier.

use super::rapier::math::{DIM, Real};
use super::rapier::prelude::*;
use super::scenes::{Scene, Steppable, install};
use super::version::{self, Pose, Vector};
use super::{UnisizeBroadPhase, rapier};
use crate::World;
use crate::drawing::{Drawing, Shape};
use rapier::parry::shape::TypedShape;
use unisize_scenes::SceneKind;

/// Half-spaces are drawn as slabs of this half width and half thickness.
const SLAB: [Real; 2] = [1000.0, 0.05];

/// Builds a scene on unisize, or on Rapier's own broad phase.
pub(crate) fn build(
    kind: SceneKind,
    bodies: usize,
    seed: u64,
    with_unisize: bool,
) -> Box<dyn World> {
    let scene = Scene::build(kind, bodies, seed);
    if with_unisize {
        Box::new(Run {
            scene,
            broad_phase: install(UnisizeBroadPhase::new()),
            unisize: Some(|broad_phase| broad_phase),
        })
    } else {
        Box::new(Run {
            scene,
            broad_phase: DefaultBroadPhase::new(),
            unisize: None,
        })
    }
}

/// A scene and its broad phase.
struct Run<B> {
    scene: Scene,
    broad_phase: B,
    /// What the broad phase is, if it is unisize.
    unisize: Option<fn(&B) -> &UnisizeBroadPhase>,
}

impl<B: Steppable> World for Run<B> {
    fn step(&mut self) -> f64 {
        self.scene.step(self.broad_phase.for_step(), &(), &());
        version::broad_phase_ms(&self.scene.world.pipeline.counters)
    }

    fn body_count(&self) -> usize {
        let bodies = self.scene.world.bodies.iter();
        bodies.filter(|(_, body)| !body.is_fixed()).count()
    }

    fn pair_count(&self) -> usize {
        let narrow_phase = &self.scene.world.narrow_phase;
        narrow_phase.contact_pairs().count() + narrow_phase.intersection_pairs().count()
    }

    fn contact_count(&self) -> usize {
        let pairs = self.scene.world.narrow_phase.contact_pairs();
        pairs.filter(|pair| version::touches(pair)).count()
    }

    fn positions(&self) -> Vec<f32> {
        let bodies = self.scene.world.bodies.iter();
        bodies
            .flat_map(|(_, body)| {
                let place = version::origin(body.position());
                (0..DIM).map(move |axis| place[axis])
            })
            .collect()
    }

    fn bounds(&self) -> [f32; 6] {
        let mut bounds = [f32::MAX, f32::MAX, f32::MAX, f32::MIN, f32::MIN, f32::MIN];
        for (_, collider) in self.scene.world.colliders.iter() {
            // Half-spaces have no end.
            if collider.shape().as_halfspace().is_some() {
                continue;
            }
            let corners = corners(collider);
            for axis in 0..3 {
                bounds[axis] = bounds[axis].min(corners[axis]);
                bounds[axis + 3] = bounds[axis + 3].max(corners[axis + 3]);
            }
        }
        bounds
    }

    fn draw(&self, drawing: &mut Drawing) {
        let world = &self.scene.world;
        for (handle, collider) in world.colliders.iter() {
            let body = collider.parent().map(|parent| &world.bodies[parent]);
            let is_fixed = body.is_none_or(|body| body.is_fixed());
            let is_asleep = body.is_some_and(|body| body.is_sleeping());
            // Neighbours differ a little, so that one sees where one ends.
            let variety = handle.into_raw_parts().0.wrapping_mul(0x9e37_79b9) >> 24;
            let shade = if is_asleep {
                0.3
            } else {
                0.7 + variety as f32 / 850.0
            };
            let (shape, half) = outline(collider, is_fixed);
            let pose: Pose = *collider.position();
            drawing.add(
                shape,
                axes(&pose, half),
                spatial(version::origin(&pose)),
                shade,
            );
        }
    }

    fn box_lines(&self) -> Vec<f32> {
        let world = &self.scene.world;
        let colliders = world.colliders.iter();
        let moving = colliders.filter(|(_, collider)| {
            let parent = collider.parent();
            parent.is_some_and(|parent| !world.bodies[parent].is_fixed())
        });
        moving
            .flat_map(|(_, collider)| edges(corners(collider)))
            .collect()
    }

    fn fat_box_lines(&self) -> Vec<f32> {
        let unisize = self.unisize.map(|unisize| unisize(&self.broad_phase));
        let boxes = unisize.into_iter().flat_map(UnisizeBroadPhase::fat_boxes);
        // Not those of half-spaces, which have no end.
        let finite = boxes.filter(|aabb| aabb.extents()[0] < SLAB[0]);
        finite.flat_map(|aabb| edges(corners_of(&aabb))).collect()
    }

    fn searches(&self) -> [f64; 3] {
        let unisize = self.unisize.map(|unisize| unisize(&self.broad_phase));
        let Some(unisize) = unisize else {
            return [0.0; 3];
        };
        let stats = unisize.stats();
        let [runs, updates] = [stats.full_searches, stats.updates].map(|count| count as f64);
        [unisize.diagnostics().foresight.into(), runs, updates]
    }

    fn pair_lines(&self, touching: bool) -> Vec<f32> {
        let colliders = &self.scene.world.colliders;
        let pairs = self.scene.world.narrow_phase.contact_pairs();
        pairs
            .filter(|pair| version::touches(pair) == touching)
            .flat_map(|pair| ends([&colliders[pair.collider1], &colliders[pair.collider2]]))
            .collect()
    }
}

/// The shape of a collider, and by how much it is scaled along each axis.
fn outline(collider: &Collider, is_fixed: bool) -> (Shape, [Real; 3]) {
    match collider.shape().as_typed_shape() {
        TypedShape::Ball(ball) if is_fixed => (Shape::Rock, [ball.radius; 3]),
        TypedShape::Ball(ball) => (Shape::Ball, [ball.radius; 3]),
        TypedShape::Capsule(capsule) => {
            let length = 2.0 * capsule.half_height() / capsule.radius;
            (Shape::Capsule(length), [capsule.radius; 3])
        }
        TypedShape::HalfSpace(_) => (Shape::Wall, [SLAB[0], SLAB[1], SLAB[0]]),
        TypedShape::Cuboid(cuboid) if is_fixed => (Shape::Wall, spatial(cuboid.half_extents)),
        TypedShape::Cuboid(cuboid) => (Shape::Cuboid, spatial(cuboid.half_extents)),
        _ => {
            let corners = corners(collider);
            let half = |axis| (corners[axis + 3] - corners[axis]) / 2.0;
            (Shape::Cuboid, std::array::from_fn(half))
        }
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

/// A vector with a third coordinate, which is 0 in the plane.
fn spatial(vector: Vector) -> [f32; 3] {
    std::array::from_fn(|axis| if axis < DIM { vector[axis] } else { 0.0 })
}

/// The lower and the upper corner of the box of a collider.
fn corners(collider: &Collider) -> [f32; 6] {
    corners_of(&collider.compute_aabb())
}

/// The lower and the upper corner of a box.
fn corners_of(aabb: &Aabb) -> [f32; 6] {
    std::array::from_fn(|index| match (index % 3, index / 3) {
        (axis, _) if axis >= DIM => 0.0,
        (axis, 0) => aabb.mins[axis],
        (axis, _) => aabb.maxs[axis],
    })
}

/// The ends of all edges of a box.
fn edges(corners: [f32; 6]) -> impl Iterator<Item = f32> {
    // A corner is a bit for each axis: whether it is an upper one. Edges lead from those where the bit of an axis is not set.
    let starts = (0..1 << DIM).flat_map(|corner| (0..DIM).map(move |axis| (corner, 1 << axis)));
    let edges = starts.filter(|(corner, axis)| corner & axis == 0);
    let ends = edges.flat_map(|(corner, axis)| [corner, corner | axis]);
    ends.flat_map(move |corner: usize| {
        (0..3).map(move |axis| corners[axis + 3 * (corner >> axis & 1)])
    })
}

/// The ends of the line from one collider to another: from centre to centre, or to the nearest point of a box that does not move.
fn ends(pair: [&Collider; 2]) -> [f32; 6] {
    let boxes = pair.map(corners);
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
