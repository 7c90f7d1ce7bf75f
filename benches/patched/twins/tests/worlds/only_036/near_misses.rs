//! Colliders whose boxes overlap and that do not touch. Rapier's narrow phase knows them as pairs, and wakes them for each other's sake;
//! with volumes they are never reported. A pipeline must behave the same.

use super::World;
use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, dynamic, fixed};

fn ball() -> ColliderBuilder {
    ColliderBuilder::ball(0.5)
}

/// What is done to a collider.
type Change = fn(&mut World, ColliderHandle);

const CHANGES: [Change; 5] = [
    |world, ball| world.colliders[ball].set_translation_wrt_parent(at(1.0, 0.0)),
    |world, ball| world.colliders[ball].set_shape(SharedShape::ball(0.4)),
    |world, ball| world.colliders[ball].set_density(3.0),
    |world, ball| world.colliders[ball].set_collision_groups(InteractionGroups::none()),
    |world, ball| world.colliders[ball].set_sensor(true),
];

/// Rapier wakes the body of a changed collider if it has ever had a pair of it.
#[test]
fn a_lamp_that_something_once_flew_past() {
    for change in CHANGES {
        for flies_past in [false, true] {
            let mut twins = Twins::heavy();
            let hook = twins.both(|world| world.bodies.insert(fixed(0.0, 5.0)));
            let (lamp, shade) = twins.insert(dynamic(0.0, 3.0), ball());
            twins.both(|world| {
                let rope = RopeJointBuilder::new(2.0);
                world.impulse_joints.insert(hook, lamp, rope, true);
            });
            let height = if flies_past { 3.85 } else { 6.0 };
            let body = dynamic(0.85, height)
                .linvel(at(10.0, 0.0))
                .gravity_scale(0.0);
            twins.insert(body, ball());
            let seen = twins.steps(400);
            assert!(seen.sleeps(lamp));
            twins.both(|world| change(world, shade));
            assert_eq!(twins.step().sleeps(lamp), !flies_past);
            twins.steps(30);
        }
    }
}

/// One is moved away, sleeps, and is moved again without being woken.
#[test]
fn what_was_near_once() {
    let mut twins = Twins::weightless();
    let (_, _) = twins.insert(fixed(0.0, 0.0), ball());
    let (body, _) = twins.insert(dynamic(0.8, 0.8), ball());
    twins.steps(3);
    twins.change_body(body, |body| body.set_translation(at(8.0, 0.0), true));
    twins.step_until(|seen| seen.sleeps(body));
    twins.change_body(body, |body| body.set_translation(at(9.0, 0.0), false));
    assert!(!twins.steps(2).sleeps(body));
}

/// Of two balls in touch one flies off along the line of centers, and the other is put to sleep. What ends an active contact wakes both;
/// this one has ended by itself before the boxes part. Couples part one after the other, so that others have just parted.
#[test]
fn a_nap_while_the_other_flies_off() {
    for angle in 0..12 {
        let (sin, cos) = (angle as Real * 0.13).sin_cos();
        for speed in [4.0, 6.0, 8.0, 10.0] {
            let mut twins = Twins::weightless();
            let couples: Vec<_> = (0..4)
                .map(|i| {
                    let y = 20.0 * i as Real;
                    let (still, _) = twins.insert(dynamic(0.0, y), ball());
                    let (flying, _) = twins.insert(dynamic(cos, y + sin), ball());
                    [still, flying]
                })
                .collect();
            twins.steps(3);
            for [still, flying] in couples {
                twins.change_body(flying, |body| {
                    body.set_linvel(at(speed * cos, speed * sin), true)
                });
                twins.step();
                twins.change_body(still, |body| body.sleep());
            }
            twins.steps(8);
        }
    }
}

/// The setter of active collision types notes no change. Rapier keeps the pair.
#[test]
fn types_that_are_emptied_and_given_back() {
    for sensor in [false, true] {
        let mut twins = Twins::weightless();
        twins.insert(fixed(0.0, 0.0), cube());
        let body = RigidBodyBuilder::kinematic_position_based().translation(at(0.3, 0.0));
        let (_, zone) = twins.insert(
            body,
            cube()
                .sensor(sensor)
                .active_collision_types(ActiveCollisionTypes::all()),
        );
        let is_seen = |twins: &mut Twins| {
            let seen = twins.step();
            seen.contacts.len() + seen.intersections.len() == 1
        };
        assert!(is_seen(&mut twins));
        for _ in 0..3 {
            let none = ActiveCollisionTypes::empty();
            twins.change(zone, |zone| zone.set_active_collision_types(none));
            twins.steps(3);
            let all = ActiveCollisionTypes::all();
            twins.change(zone, |zone| zone.set_active_collision_types(all));
            assert!(is_seen(&mut twins));
        }
    }
}
