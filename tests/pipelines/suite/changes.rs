//! What a user changes about a collider or body while it touches another.

use super::PairFilter;
use super::rapier::prelude::*;
use super::snapshot::Snapshot;
use super::twins::{Twins, at, cube, cuboid, dynamic, fixed};
use super::version::{self, pose};

/// A cube on a fixed floor, touching it.
struct Resting {
    twins: Twins,
    body: RigidBodyHandle,
    cube: ColliderHandle,
    floor_body: RigidBodyHandle,
    floor: ColliderHandle,
}

impl Resting {
    fn with(filter: PairFilter) -> Self {
        let mut twins = Twins::with_filter(filter);
        let (floor_body, floor) = twins.insert_floor();
        let (body, cube) = twins.insert(dynamic(0.0, 0.5), cube());
        assert!(twins.steps(10).touches(cube, floor));
        Self {
            twins,
            body,
            cube,
            floor_body,
            floor,
        }
    }

    /// Makes a change that must end the contact, and one that must restore it, with every filter.
    fn part_and_meet(part: impl Fn(&mut Self), meet: impl Fn(&mut Self), removed: bool) {
        for filter in [PairFilter::Off, PairFilter::Bodies, PairFilter::Groups] {
            let mut resting = Self::with(filter);
            for _ in 0..3 {
                part(&mut resting);
                let seen = resting.twins.step();
                assert!(!seen.touches(resting.cube, resting.floor));
                assert!(seen.stopped(resting.cube, resting.floor, removed));
                resting.twins.steps(2);
                meet(&mut resting);
                let seen = resting.twins.step();
                assert!(seen.touches(resting.cube, resting.floor));
                assert!(seen.started(resting.cube, resting.floor));
                resting.twins.steps(2);
            }
        }
    }
}

fn groups(bits: Group) -> InteractionGroups {
    version::groups(bits, bits)
}

#[test]
fn disabled_colliders() {
    Resting::part_and_meet(
        |it| it.twins.change(it.cube, |cube| cube.set_enabled(false)),
        |it| it.twins.change(it.cube, |cube| cube.set_enabled(true)),
        true,
    );
    Resting::part_and_meet(
        |it| it.twins.change(it.floor, |floor| floor.set_enabled(false)),
        |it| it.twins.change(it.floor, |floor| floor.set_enabled(true)),
        true,
    );
}

#[test]
fn disabled_bodies() {
    Resting::part_and_meet(
        |it| {
            it.twins
                .change_body(it.body, |body| body.set_enabled(false))
        },
        |it| it.twins.change_body(it.body, |body| body.set_enabled(true)),
        true,
    );
    Resting::part_and_meet(
        |it| {
            it.twins
                .change_body(it.floor_body, |body| body.set_enabled(false))
        },
        |it| {
            it.twins
                .change_body(it.floor_body, |body| body.set_enabled(true))
        },
        true,
    );
}

#[test]
fn collision_groups() {
    Resting::part_and_meet(
        |it| {
            let [floor, cube] = [groups(Group::GROUP_1), groups(Group::GROUP_2)];
            it.twins
                .change(it.floor, |it| it.set_collision_groups(floor));
            it.twins.change(it.cube, |it| it.set_collision_groups(cube));
        },
        |it| {
            let all = InteractionGroups::all();
            it.twins.change(it.cube, |it| it.set_collision_groups(all));
        },
        false,
    );
}

#[test]
fn body_types() {
    for kind in [
        RigidBodyType::Fixed,
        RigidBodyType::KinematicPositionBased,
        RigidBodyType::KinematicVelocityBased,
    ] {
        Resting::part_and_meet(
            |it| {
                it.twins
                    .change_body(it.body, |body| body.set_body_type(kind, true))
            },
            |it| {
                let set = |body: &mut RigidBody| body.set_body_type(RigidBodyType::Dynamic, true);
                it.twins.change_body(it.body, set);
            },
            false,
        );
    }
}

/// Its type changes while it is in flight, so only its box is handed over between.
#[test]
fn body_types_in_flight() {
    let mut twins = Twins::weightless();
    let (_, gate) = twins.insert(fixed(6.0, 0.0), cube());
    let body = RigidBodyBuilder::kinematic_velocity_based().linvel(at(2.0, 0.0));
    let (body, ball) = twins.insert(body, ColliderBuilder::ball(0.5));
    for step in 0..400 {
        if step % 40 == 20 {
            let kind = match step / 40 % 3 {
                0 => RigidBodyType::Dynamic,
                1 => RigidBodyType::KinematicVelocityBased,
                _ => RigidBodyType::KinematicPositionBased,
            };
            twins.change_body(body, |body| body.set_body_type(kind, true));
        }
        twins.step();
    }
    twins.change_body(body, |body| {
        body.set_body_type(RigidBodyType::Dynamic, true);
        body.set_translation(at(5.2, 0.0), true);
    });
    assert!(twins.steps(2).touches(ball, gate));
}

#[test]
fn pairs_forbidden_from_the_start() {
    let mut twins = Twins::weightless();
    let (left_body, left) = twins.insert(fixed(0.0, 0.0), cube());
    let (_, right) = twins.insert(fixed(0.9, 0.0), cube());
    assert!(!twins.steps(3).touches(left, right));
    twins.change_body(left_body, |body| {
        body.set_body_type(RigidBodyType::Dynamic, true)
    });
    assert!(twins.step().touches(left, right));
}

#[test]
fn active_collision_types() {
    let mut twins = Twins::weightless();
    let (_, left) = twins.insert(RigidBodyBuilder::kinematic_velocity_based(), cube());
    let (_, right) = twins.insert(fixed(0.9, 0.0), cube());
    assert!(!twins.steps(3).touches(left, right));
    for (types, x) in [
        (ActiveCollisionTypes::all(), 0.01),
        (ActiveCollisionTypes::empty(), 0.0),
        (ActiveCollisionTypes::KINEMATIC_FIXED, 0.01),
    ] {
        twins.change(left, |left| {
            left.set_active_collision_types(types);
            // Rapier looks at the types again when the collider moves.
            left.set_translation_wrt_parent(at(x, 0.3));
        });
        assert_eq!(twins.step().touches(left, right), !types.is_empty());
        twins.steps(2);
    }
}

#[test]
fn parents() {
    let mut twins = Twins::weightless();
    let (first, left) = twins.insert(dynamic(0.0, 0.0), cube());
    let right = twins.insert_part(first, cube().translation(at(0.9, 0.0)));
    let second = twins.both(|world| world.bodies.insert(dynamic(0.0, 0.0)));
    assert!(!twins.steps(3).touches(left, right));
    for _ in 0..2 {
        twins.set_parent(right, Some(second));
        let seen = twins.step();
        assert!(seen.touches(left, right) && seen.started(left, right));
        twins.set_parent(right, Some(first));
        let seen = twins.step();
        assert!(!seen.touches(left, right) && seen.stopped(left, right, false));
        for body in [first, second] {
            twins.change_body(body, |body| {
                body.set_position(pose(at(0.0, 0.0)), true);
                body.set_vels(RigidBodyVelocity::zero(), true);
            });
        }
    }
    twins.set_parent(right, None);
    assert!(twins.step().touches(left, right));
}

#[test]
fn sensors() {
    let mut twins = Twins::weightless();
    let (_, gate) = twins.insert(fixed(0.0, 0.0), cube().sensor(true));
    let (_, ball) = twins.insert(
        dynamic(-3.0, 0.0).linvel(at(4.0, 0.0)),
        ColliderBuilder::ball(0.5),
    );
    let inside = |seen: &Snapshot| seen.intersects(gate, ball);
    assert!(twins.step_until(inside).contacts.is_empty());
    twins.step_until(|seen| !inside(seen));
}

#[test]
fn sensors_toggled() {
    let mut twins = Twins::heavy();
    let (_, floor) = twins.insert_floor();
    let (_, cube) = twins.insert(dynamic(0.0, 0.5), cube());
    for is_sensor in [false, true, false, true] {
        twins.change(cube, |cube| cube.set_sensor(is_sensor));
        let seen = twins.steps(2);
        assert_eq!(seen.intersects(cube, floor), is_sensor);
        assert_eq!(seen.touches(cube, floor), !is_sensor);
    }
}

/// After a step its box has been handed over; then the user moves it, and it is listed as well.
#[test]
fn teleports() {
    let mut twins = Twins::weightless();
    let places: Vec<_> = (0..10).map(|i| at(4.0 * i as Real, 0.0)).collect();
    for &place in &places {
        twins.insert(
            RigidBodyBuilder::fixed().translation(place),
            cuboid([0.5, 0.1, 0.5]),
        );
    }
    let moving = dynamic(0.0, 2.0).linvel(at(0.5, -1.0));
    let (body, _) = twins.insert(moving, ColliderBuilder::ball(0.3));
    let mut met = 0;
    for round in 0..40 {
        let place = places[round * 7 % 10] + at(0.1, 0.35 + 0.02 * (round % 4) as Real);
        twins.change_body(body, |body| {
            body.set_translation(place, true);
            body.set_linvel(at(0.5, -1.0), true);
        });
        met += twins.steps(1 + round % 5).contacts.len();
    }
    assert!(met > 5, "it meets {met}");
}

#[test]
fn shapes_and_skins() {
    let mut twins = Twins::weightless();
    let (_, left) = twins.insert(fixed(0.0, 0.0), cube());
    let (_, right) = twins.insert(dynamic(2.0, 0.0), ColliderBuilder::ball(0.5));
    assert!(!twins.steps(3).touches(left, right));
    for (shape, touches) in [
        (SharedShape::ball(1.51), true),
        (SharedShape::ball(0.5), false),
        (SharedShape::capsule_x(1.2, 0.31), true),
        (SharedShape::ball(0.5), false),
    ] {
        twins.change(right, |right| right.set_shape(shape.clone()));
        assert_eq!(twins.step().touches(left, right), touches);
        twins.both(|world| {
            for (_, body) in world.bodies.iter_mut() {
                body.set_vels(RigidBodyVelocity::zero(), true);
                if body.is_dynamic() {
                    body.set_translation(at(2.0, 0.0), true);
                }
            }
        });
    }
}
