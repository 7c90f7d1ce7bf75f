//! Rapier's `CollisionPipeline`: collisions without dynamics.

use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, cuboid, dynamic, fixed};
use super::version;

/// Inserts a collider without a body that meets everything.
fn insert_loose(twins: &mut Twins, x: Real, sensor: bool) -> ColliderHandle {
    twins.both(|world| {
        let collider = cube()
            .translation(at(x, 0.0))
            .sensor(sensor)
            .active_collision_types(ActiveCollisionTypes::all())
            .active_events(ActiveEvents::COLLISION_EVENTS);
        world.colliders.insert(collider)
    })
}

#[test]
fn colliders_without_bodies() {
    let mut twins = Twins::weightless();
    let solid = insert_loose(&mut twins, 0.0, false);
    let moving = insert_loose(&mut twins, 5.0, false);
    let sensor = insert_loose(&mut twins, -1.5, true);
    for i in 0..60 {
        let x = 5.0 - 0.15 * i as Real;
        twins.change(moving, |moving| moving.set_translation(at(x, 0.0)));
        let seen = twins.collide();
        assert_eq!(seen.touches(solid, moving), x.abs() < 1.002, "at {x}");
        assert_eq!(
            seen.intersects(sensor, moving),
            (x + 1.5).abs() <= 1.0,
            "at {x}"
        );
    }
    // Nothing has changed.
    assert!(twins.collide().events.is_empty());
}

#[test]
fn colliders_that_come_and_go() {
    let mut twins = Twins::weightless();
    let solid = insert_loose(&mut twins, 0.0, false);
    let other = insert_loose(&mut twins, 0.9, false);
    assert!(twins.collide().started(solid, other));
    twins.change(other, |other| other.set_enabled(false));
    assert!(twins.collide().stopped(solid, other, true));
    twins.change(other, |other| other.set_enabled(true));
    assert!(twins.collide().started(solid, other));
    twins.both(|world| world.remove_collider(other));
    assert!(twins.collide().stopped(solid, other, true));
    let again = insert_loose(&mut twins, 0.9, false);
    assert!(twins.collide().started(solid, again));
}

/// This pipeline never clears the marks of changed bodies, so it lists the colliders of a body only at the
/// first of its changes. The narrow phase looks at body types all the same, whenever either collider moves.
#[test]
fn a_body_type_that_changes_unlisted() {
    let mut twins = Twins::weightless();
    let (body, left) = twins.insert(fixed(0.0, 0.0), cube());
    let (_, right) = twins.insert(fixed(0.9, 0.0), cube());
    assert!(!twins.collide().touches(left, right));
    twins.change_body(body, |body| {
        body.set_body_type(RigidBodyType::Dynamic, true)
    });
    twins.collide();
    twins.change(right, |right| right.set_translation(at(0.95, 0.0)));
    assert!(twins.collide().touches(left, right));
}

/// This pipeline has the margin of a length unit of 1, and steps have that of their world. So the two alternate.
///
/// What flies are sensors: Rapier 0.36 does not expect that contacts begin between two steps.
#[test]
fn between_the_steps_of_a_world_with_another_length_unit() {
    let mut twins = Twins::weightless();
    twins.both(|world| {
        world.params.length_unit = 100.0;
        version::look_at_contacts_anew(&mut world.params);
    });
    let shapes = [cuboid([50.0; 3]), ColliderBuilder::ball(50.0)];
    let pairs = [0, 1, 2, 3, 4, 5].map(|i| {
        let height = 400.0 * i as Real;
        let sleeper = dynamic(0.0, height).sleeping(true);
        let (_, sleeper) = twins.insert(sleeper, shapes[i % 2].clone());
        let flyer = dynamic(-150.0 - 10.0 * i as Real, height + 20.0).linvel(at(200.0, 0.0));
        let (_, flyer) = twins.insert(flyer, shapes[i / 3].clone().sensor(true));
        [sleeper, flyer]
    });
    let mut met = pairs.map(|_| false);
    for _ in 0..90 {
        for seen in [twins.step(), twins.collide()] {
            for (met, [a, b]) in met.iter_mut().zip(pairs) {
                *met |= seen.intersects(a, b);
            }
        }
    }
    assert_eq!(met, pairs.map(|_| true));
}
