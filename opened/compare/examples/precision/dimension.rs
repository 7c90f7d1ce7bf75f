//! Counts the pairs of a scene: one source, compiled once in each dimension.

use super::scenes::Scene;
use super::scenes::rapier::math::{self, DIM};
use super::scenes::rapier::parry::query;
use super::scenes::rapier::prelude::*;
use crate::volume::{Vector, Volume, directions};
use crate::{Counts, STEPS, TESTS, Test};
use unisize_scenes::SceneKind;

/// Counts in the second half of a run.
pub(crate) fn count(kind: SceneKind, bodies: usize) -> Counts {
    let mut scene = Scene::build(kind, bodies, 1);
    let mut broad_phase = DefaultBroadPhase::new();
    let mut counts = Counts::default();
    for step in 1..=STEPS {
        scene.prepare();
        // What the pairs of this step were found from.
        let colliders = (step > STEPS / 2 && step % 10 == 0).then(|| scene.world.colliders.clone());
        scene.world.step(&mut broad_phase, &(), &());
        let Some(colliders) = colliders else {
            continue;
        };
        let prediction = scene.world.params.prediction_distance();
        for pair in scene.world.narrow_phase.contact_pairs() {
            counts.contacts += usize::from(pair.has_any_active_contact());
            let [a, b] = [pair.collider1, pair.collider2].map(|handle| colliders.get(handle));
            if let (Some(a), Some(b)) = (a, b) {
                for (count, test) in counts.pairs.iter_mut().zip(TESTS) {
                    *count += usize::from(is_left(test, [a, b], prediction));
                }
            }
        }
    }
    counts
}

/// Whether a test does not tell two colliders apart, whose shapes are loosened by half of this distance each.
pub(crate) fn is_left(test: Test, [a, b]: [&Collider; 2], distance: Real) -> bool {
    if test == Test::Margins {
        return true;
    }
    let boxes = [a, b].map(|collider| collider.compute_collision_aabb(distance / 2.0));
    let boxes_meet = boxes[0].intersects(&boxes[1]);
    if test == Test::Distance {
        let found = query::distance(a.position(), a.shape(), b.position(), b.shape());
        let reach = distance + a.contact_skin() + b.contact_skin() + 1.0e-6;
        return boxes_meet && found.is_ok_and(|found| found.distance <= reach);
    }
    let [Some((a, own_a)), Some((b, own_b))] = [a, b].map(|collider| volume(collider, distance))
    else {
        // A mesh or the like, whose box is all there is.
        return boxes_meet;
    };
    let corners = || a.is_apart(&b, &directions::<DIM>(DIM));
    let edges = || a.is_apart(&b, &directions::<DIM>(2));
    let own = || a.is_apart(&b, own_a.iter().chain(&own_b));
    boxes_meet
        && !match test {
            Test::Margins | Test::Boxes | Test::Distance => false,
            Test::Balls => a.is_apart_by_balls(&b),
            Test::Corners => corners(),
            Test::Edges => edges(),
            Test::Both => corners() || edges(),
            Test::Centres => a.is_apart(&b, &[a.to(&b)]),
            Test::OwnAxes => own(),
            Test::Points => own() || a.is_apart(&b, &[a.shortest_to(&b)]),
        }
}

/// The bounding volume of a collider's shape, if it has one but its box, and the axes of the shape.
fn volume(collider: &Collider, prediction: Real) -> Option<(Volume<DIM>, Vec<Vector<DIM>>)> {
    let (shape, pose) = (collider.shape(), collider.position());
    let reach = f64::from(prediction / 2.0 + collider.contact_skin());
    let numbers = |vector: math::Vector| <[Real; DIM]>::from(vector).map(f64::from);
    if let Some(ball) = shape.as_ball() {
        let volume = Volume {
            center: numbers(pose.translation),
            radius: f64::from(ball.radius) + reach,
            half_axes: Vec::new(),
        };
        return Some((volume, Vec::new()));
    }
    if let Some(capsule) = shape.as_capsule() {
        let [start, end] = [capsule.segment.a, capsule.segment.b].map(|point| *pose * point);
        let volume = Volume {
            center: numbers((start + end) * 0.5),
            radius: f64::from(capsule.radius) + reach,
            half_axes: vec![numbers((end - start) * 0.5)],
        };
        return Some((volume, Vec::new()));
    }
    if let Some(half_space) = shape.as_halfspace() {
        // As thick as any world.
        let normal = numbers(pose.rotation * half_space.normal);
        let thickness = 1.0e6;
        let origin = numbers(pose.translation);
        let volume = Volume {
            center: std::array::from_fn(|k| origin[k] - thickness * normal[k]),
            radius: thickness + reach,
            half_axes: Vec::new(),
        };
        return Some((volume, vec![normal]));
    }
    if shape.as_composite_shape().is_some() && shape.as_compound().is_none() {
        return None;
    }
    let aabb = shape.compute_local_aabb();
    let half = <[Real; DIM]>::from(aabb.half_extents());
    let axes: Vec<_> = (0..DIM)
        .map(|k| {
            let mut unit = [0.0; DIM];
            unit[k] = 1.0;
            numbers(pose.rotation * math::Vector::from(unit))
        })
        .collect();
    let half_axes = axes.iter().zip(half);
    let volume = Volume {
        center: numbers(*pose * aabb.center()),
        radius: reach,
        half_axes: half_axes
            .map(|(axis, half)| axis.map(|x| x * f64::from(half)))
            .collect(),
    };
    Some((volume, axes))
}
