//! What a user changes about a collider or body while it touches another, and pairs that are left out because they can have no effect:
//! with each filter, what can be seen is the same as with Rapier's own broad phase.

use super::rapier::prelude::*;
use super::scenes::groups;
use super::twins::{Twins, at, cube, dynamic, fixed};
use super::{PairFilter, World};

/// How many steps are made after each change.
const STEPS: usize = 3;

fn for_each_filter(test: impl Fn(Twins)) {
    for filter in [
        PairFilter::Off,
        PairFilter::Bodies,
        PairFilter::Groups,
        PairFilter::Shapes,
    ] {
        test(Twins::with_filter(filter));
    }
}

/// A body that stays awake.
fn sleepless(x: Real) -> RigidBodyBuilder {
    dynamic(x, 0.0).can_sleep(false)
}

/// The handles of a fixed floor, and of a cube that touches it.
type Bodies = [RigidBodyHandle; 2];
type Colliders = [ColliderHandle; 2];

/// Makes a change that must end a contact, and, told that the two are to meet, one that must restore it.
fn part_and_meet(removes: bool, change: impl Fn(&mut World, Bodies, Colliders, bool)) {
    for_each_filter(|mut twins| {
        let (floor_body, floor) = twins.insert_floor();
        let (body, cube) = twins.insert(dynamic(0.0, 0.5), cube());
        let (bodies, colliders) = ([floor_body, body], [floor, cube]);
        assert!(twins.steps(10).touches(cube, floor));
        for _ in 0..3 {
            twins.both(|world| change(world, bodies, colliders, false));
            let seen = twins.step();
            assert!(!seen.touches(cube, floor));
            assert!(seen.stopped(cube, floor, removes));
            twins.steps(2);
            twins.both(|world| change(world, bodies, colliders, true));
            let seen = twins.step();
            assert!(seen.touches(cube, floor) && seen.started(cube, floor));
            twins.steps(2);
        }
    });
}

#[test]
fn enabling() {
    for which in [0, 1] {
        part_and_meet(true, |world, _, colliders, meet| {
            world.colliders[colliders[which]].set_enabled(meet);
        });
        part_and_meet(true, |world, bodies, _, meet| {
            world.bodies[bodies[which]].set_enabled(meet);
        });
    }
}

#[test]
fn collision_groups() {
    part_and_meet(false, |world, _, [floor, cube], meet| {
        let other = if meet { Group::ALL } else { Group::GROUP_2 };
        let [one, other] = [Group::GROUP_1, other].map(|bits| groups(bits, bits));
        world.colliders[floor].set_collision_groups(one);
        world.colliders[cube].set_collision_groups(other);
    });
}

#[test]
fn body_types() {
    for kind in [
        RigidBodyType::Fixed,
        RigidBodyType::KinematicPositionBased,
        RigidBodyType::KinematicVelocityBased,
    ] {
        part_and_meet(false, |world, [_, body], _, meet| {
            let kind = if meet { RigidBodyType::Dynamic } else { kind };
            world.bodies[body].set_body_type(kind, true);
        });
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
fn collision_types() {
    for_each_filter(|twins| {
        let mut twins = twins.without_gravity();
        let (body, left) = twins.insert(fixed(0.0, 0.0), cube());
        let (_, right) = twins.insert(fixed(0.9, 0.0), cube());
        assert!(!twins.steps(STEPS).touches(left, right));
        for (kind, types, x) in [
            (RigidBodyType::Fixed, ActiveCollisionTypes::all(), 0.01),
            (RigidBodyType::Fixed, ActiveCollisionTypes::empty(), 0.0),
            (
                RigidBodyType::Fixed,
                ActiveCollisionTypes::FIXED_FIXED,
                0.01,
            ),
            (
                RigidBodyType::KinematicPositionBased,
                ActiveCollisionTypes::default(),
                0.0,
            ),
            (
                RigidBodyType::KinematicPositionBased,
                ActiveCollisionTypes::KINEMATIC_FIXED,
                0.01,
            ),
        ] {
            twins.change_body(body, |body| body.set_body_type(kind, true));
            twins.change(left, |left| {
                left.set_active_collision_types(types);
                // Rapier looks at the types again when the collider moves.
                left.set_translation_wrt_parent(at(x, 0.0));
            });
            let touches = x > 0.0;
            assert_eq!(twins.step().touches(left, right), touches);
            assert_eq!(twins.steps(STEPS).touches(left, right), touches);
        }
    });
}

#[test]
fn sensors() {
    for_each_filter(|twins| {
        let mut twins = twins.without_gravity();
        let (_, left) = twins.insert(fixed(0.0, 0.0), cube());
        let (body, right) = twins.insert(sleepless(0.999), cube());
        assert!(twins.steps(STEPS).touches(left, right));
        for is_sensor in [true, false, true] {
            twins.change(right, |right| right.set_sensor(is_sensor));
            twins.change_body(body, |body| body.set_translation(at(0.95, 0.0), true));
            let seen = twins.steps(STEPS);
            assert_eq!(seen.intersects(left, right), is_sensor);
            assert_eq!(seen.touches(left, right), !is_sensor);
        }
        // Two fixed ones do not meet, whether one of them is a sensor or not.
        twins.change_body(body, |body| body.set_body_type(RigidBodyType::Fixed, true));
        assert!(!twins.steps(STEPS).intersects(left, right));
        twins.change(right, |right| right.set_sensor(false));
        assert!(!twins.steps(STEPS).touches(left, right));
    });
}

/// Nothing is held that can have no effect.
#[test]
fn what_is_left_out_is_not_held() {
    let pairs_with = |filter| {
        let mut twins = Twins::with_filter(filter).without_gravity();
        for x in 0..4 {
            twins.insert(fixed(0.9 * x as Real, 0.0), cube());
        }
        let thin = InteractionGroups::none();
        twins.insert(
            sleepless(0.5).translation(at(0.5, 0.9)),
            cube().collision_groups(thin),
        );
        // Beside its corner.
        let ball = ColliderBuilder::ball(0.5);
        twins.insert(sleepless(0.5).translation(at(-0.9, -0.9)), ball);
        twins.steps(STEPS);
        twins.unisize.stats().pairs
    };
    assert_eq!(pairs_with(PairFilter::Off), 6);
    assert_eq!(pairs_with(PairFilter::Bodies), 3);
    assert_eq!(pairs_with(PairFilter::Groups), 1);
    assert_eq!(pairs_with(PairFilter::Shapes), 0);
}
