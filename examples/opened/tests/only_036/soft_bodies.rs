//! Soft bodies: their colliders are made, deformed and taken away by the engine.

use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, dynamic, fixed};
use super::{World, soft_body};

fn insert(world: &mut World, body: SoftBodyBuilder) -> SoftBodyHandle {
    let (bodies, colliders) = (&mut world.bodies, &mut world.colliders);
    world.soft_bodies.insert(body, bodies, colliders)
}

fn remove(world: &mut World, body: SoftBodyHandle) {
    let removed = world.soft_bodies.remove(
        body,
        &mut world.islands,
        &mut world.bodies,
        &mut world.colliders,
        &mut world.impulse_joints,
        &mut world.multibody_joints,
    );
    assert!(removed.is_some());
}

/// One that falls on a floor, and a cube that falls on it. The cube meets nothing else, and it the floor and the cube.
#[test]
fn one_that_falls_and_one_that_is_fallen_on() {
    let mut twins = Twins::heavy();
    let (_, floor) = twins.insert_floor();
    let handle = twins.both(|world| insert(world, soft_body(at(0.0, 1.5), 0.8)));
    let (_, cube) = twins.insert(dynamic(0.0, 4.5), cube().density(0.2));
    let before = twins.unisize.stats().proxies;
    let mut touched = [false; 2];
    for step in 0..150 {
        let seen = twins.step();
        let met: Vec<_> = seen.contacts.iter().copied().collect();
        let meets = |collider: ColliderHandle| {
            let collider = collider.into_raw_parts();
            met.iter().any(|pair| pair.contains(&collider))
        };
        touched = [touched[0] | meets(floor), touched[1] | meets(cube)];
        if step == 0 {
            assert!(twins.unisize.stats().proxies > before);
        }
    }
    assert_eq!(touched, [true; 2], "the floor, and the cube");
    let tracked = twins.unisize.stats().proxies;
    assert_eq!(tracked, twins.ours.colliders.iter_enabled().count());
    twins.both(|world| remove(world, handle));
    twins.step();
    assert_eq!(twins.unisize.stats().proxies, 2);
    twins.steps(20);
}

/// A rope that hangs down and swings against a body.
#[test]
fn a_soft_rope() {
    let mut twins = Twins::heavy();
    twins.both(|world| {
        let rope = SoftBodyBuilder::rope(at(0.0, 0.0), at(3.0, 0.0), 16).pinned_particles([0]);
        insert(world, rope)
    });
    twins.insert(fixed(-0.9, -2.0), cube());
    let mut contacts = 0;
    for _ in 0..200 {
        contacts += twins.step().contacts.len();
    }
    assert!(contacts > 0);
}
