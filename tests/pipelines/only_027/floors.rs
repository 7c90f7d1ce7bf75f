//! Bodies of every shape come to rest, one by one, on floors of every kind.

use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, cuboid, dynamic, triple};
use super::version::{pose, unit};
use super::{height_field, mesh_floor};

/// Drops bodies far from each other onto a floor until all sleep on it.
fn come_to_rest_on(floor: ColliderBuilder) {
    let mut twins = Twins::heavy();
    let (_, floor) = twins.insert(RigidBodyBuilder::fixed(), floor);
    let dumbbell = ColliderBuilder::compound(vec![
        (pose(at(-0.5, 0.0)), SharedShape::ball(0.25)),
        (pose(at(0.5, 0.0)), SharedShape::ball(0.25)),
    ]);
    let shapes = [
        ColliderBuilder::ball(0.5),
        cube(),
        cuboid([0.5, 0.25, 0.5]),
        ColliderBuilder::capsule_x(0.5, 0.25),
        dumbbell,
        cube().contact_skin(0.1),
    ];
    let mut fallen = Vec::new();
    for (i, shape) in shapes.into_iter().enumerate() {
        // Damped, so that what is round does not roll for long.
        let body = dynamic(4.0 * i as Real - 11.3, 1.0 + 0.1 * i as Real);
        let body = body.linear_damping(0.5).angular_damping(2.0);
        fallen.push(twins.insert(body, shape));
    }
    let last = twins.step_until(|seen| fallen.iter().all(|&(body, _)| seen.sleeps(body)));
    for (body, collider) in fallen {
        assert!(last.touches(collider, floor));
        assert!(last.height(body) > 0.0);
    }
}

#[test]
fn cuboid_floor() {
    come_to_rest_on(cuboid([50.0, 1.0, 50.0]).translation(at(0.0, -1.0)));
}

#[test]
fn half_space_floor() {
    come_to_rest_on(ColliderBuilder::new(SharedShape::halfspace(unit(at(
        0.0, 1.0,
    )))));
}

#[test]
fn mesh() {
    come_to_rest_on(mesh_floor(50.0));
}

#[test]
fn height_field_floor() {
    come_to_rest_on(height_field(50.0));
}

#[test]
fn compound_floor() {
    let plate = SharedShape::new(Cuboid::new(triple([25.0, 1.0, 50.0])));
    come_to_rest_on(ColliderBuilder::compound(vec![
        (pose(at(-25.0, -1.0)), plate.clone()),
        (pose(at(25.0, -1.0)), plate),
    ]));
}

#[test]
fn contact_skins_touch_across_a_gap() {
    let mut twins = Twins::weightless();
    let (_, left) = twins.insert(dynamic(0.0, 0.0), cube().contact_skin(0.05));
    let (_, right) = twins.insert(dynamic(1.08, 0.0), cube().contact_skin(0.05));
    assert!(twins.step().touches(left, right));
    twins.change(right, |collider| {
        collider.set_contact_skin(0.0);
        collider.set_shape(SharedShape::new(Cuboid::new(triple([0.4; 3]))));
    });
    assert!(!twins.step().touches(left, right));
}
