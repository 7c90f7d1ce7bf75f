//! What a user changes about a collider or body while it touches another.

use super::rapier::prelude::*;
use super::snapshot::Snapshot;
use super::twins::{Twins, at, cube, dynamic, fixed};

/// A cube on a fixed floor, touching it.
struct Resting {
    twins: Twins,
    body: RigidBodyHandle,
    cube: ColliderHandle,
    floor_body: RigidBodyHandle,
    floor: ColliderHandle,
}

impl Resting {
    fn new() -> Self {
        let mut twins = Twins::heavy();
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

    /// Makes a change that must end the contact, and one that must restore it.
    fn part_and_meet(mut self, part: impl Fn(&mut Self), meet: impl Fn(&mut Self), removed: bool) {
        for _ in 0..3 {
            part(&mut self);
            let seen = self.twins.step();
            assert!(!seen.touches(self.cube, self.floor));
            assert!(seen.stopped(self.cube, self.floor, removed));
            self.twins.steps(2);
            meet(&mut self);
            let seen = self.twins.step();
            assert!(seen.touches(self.cube, self.floor));
            assert!(seen.started(self.cube, self.floor));
            self.twins.steps(2);
        }
    }

    fn change(&mut self, change: impl Fn(&mut Collider)) {
        self.twins.change(self.cube, change);
    }
}

#[test]
fn disabled_collider() {
    Resting::new().part_and_meet(
        |it| it.change(|cube| cube.set_enabled(false)),
        |it| it.change(|cube| cube.set_enabled(true)),
        true,
    );
}

#[test]
fn disabled_floor() {
    Resting::new().part_and_meet(
        |it| it.twins.change(it.floor, |floor| floor.set_enabled(false)),
        |it| it.twins.change(it.floor, |floor| floor.set_enabled(true)),
        true,
    );
}

#[test]
fn disabled_body() {
    Resting::new().part_and_meet(
        |it| {
            it.twins
                .change_body(it.body, |body| body.set_enabled(false))
        },
        |it| it.twins.change_body(it.body, |body| body.set_enabled(true)),
        true,
    );
}

#[test]
fn disabled_body_of_the_floor() {
    Resting::new().part_and_meet(
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
fn groups() {
    let others = InteractionGroups::new(Group::GROUP_2, Group::GROUP_2);
    let mut resting = Resting::new();
    let first = InteractionGroups::new(Group::GROUP_1, Group::GROUP_1);
    resting
        .twins
        .change(resting.floor, |floor| floor.set_collision_groups(first));
    resting.part_and_meet(
        |it| it.change(|cube| cube.set_collision_groups(others)),
        |it| it.change(|cube| cube.set_collision_groups(InteractionGroups::all())),
        false,
    );
}

#[test]
fn body_type() {
    for kind in [
        RigidBodyType::Fixed,
        RigidBodyType::KinematicPositionBased,
        RigidBodyType::KinematicVelocityBased,
    ] {
        Resting::new().part_and_meet(
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
    let all = ActiveCollisionTypes::all();
    twins.change(right, |collider| collider.set_active_collision_types(all));
    // Rapier looks again once something moves.
    twins.steps(2);
    twins.change(left, |collider| {
        collider.set_translation_wrt_parent(at(0.01, 0.0))
    });
    assert!(twins.step().touches(left, right));
}

#[test]
fn reparented() {
    let mut twins = Twins::weightless();
    let (first, left) = twins.insert(dynamic(0.0, 0.0), cube());
    let right = twins.both(|world| {
        let right = cube()
            .translation(at(0.9, 0.0))
            .active_events(ActiveEvents::all());
        world
            .colliders
            .insert_with_parent(right, first, &mut world.bodies)
    });
    let second = twins.both(|world| world.bodies.insert(dynamic(0.0, 0.0)));
    assert!(!twins.steps(3).touches(left, right));
    for _ in 0..2 {
        twins.both(|world| {
            world
                .colliders
                .set_parent(right, Some(second), &mut world.bodies)
        });
        let seen = twins.step();
        assert!(seen.touches(left, right) && seen.started(left, right));
        twins.both(|world| {
            world
                .colliders
                .set_parent(right, Some(first), &mut world.bodies)
        });
        let seen = twins.step();
        assert!(!seen.touches(left, right) && seen.stopped(left, right, false));
        twins.change_body(second, |body| body.set_position(Isometry::identity(), true));
        twins.change_body(first, |body| body.set_position(Isometry::identity(), true));
    }
    twins.both(|world| world.colliders.set_parent(right, None, &mut world.bodies));
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
fn sensor_toggled() {
    let mut twins = Twins::heavy();
    let (_, floor) = twins.insert_floor();
    let (_, cube) = twins.insert(dynamic(0.0, 0.5), cube());
    assert!(twins.steps(5).touches(cube, floor));
    twins.change(cube, |cube| cube.set_sensor(true));
    let seen = twins.steps(2);
    assert!(seen.intersects(cube, floor) && !seen.touches(cube, floor));
    twins.change(cube, |cube| cube.set_sensor(false));
    let seen = twins.steps(2);
    assert!(!seen.intersects(cube, floor) && seen.touches(cube, floor));
}
