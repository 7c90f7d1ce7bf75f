//! Pairs that are left out because they can have no effect, and every way in which they can come to have one, or cease to:
//! with each filter, what can be seen is the same as with Rapier's own broad phase, where nobody sleeps.

use super::PairFilter;
use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, cuboid, dynamic, fixed};

/// How many steps are made after each change.
const STEPS: usize = 3;

fn for_each_filter(test: impl Fn(Twins)) {
    for filter in [
        PairFilter::Off,
        PairFilter::Bodies,
        PairFilter::Groups,
        PairFilter::Shapes,
    ] {
        test(Twins::with_filter(filter).without_gravity());
    }
}

/// A body that stays awake.
fn sleepless(x: Real) -> RigidBodyBuilder {
    dynamic(x, 0.0).can_sleep(false)
}

#[test]
fn body_types() {
    for_each_filter(|mut twins| {
        let (body, left) = twins.insert(fixed(0.0, 0.0).can_sleep(false), cube());
        let (_, right) = twins.insert(fixed(0.9, 0.0), cube());
        assert!(!twins.steps(STEPS).touches(left, right));
        for (to, touches) in [
            (RigidBodyType::Dynamic, true),
            (RigidBodyType::KinematicPositionBased, false),
            (RigidBodyType::Dynamic, true),
            (RigidBodyType::Fixed, false),
            (RigidBodyType::KinematicVelocityBased, false),
            (RigidBodyType::Dynamic, true),
        ] {
            twins.change_body(body, |body| {
                body.set_body_type(to, true);
                body.set_translation(at(0.0, 0.0), true);
            });
            assert_eq!(twins.step().touches(left, right), touches, "{to:?}");
            twins.steps(STEPS);
        }
    });
}

#[test]
fn parents() {
    for_each_filter(|mut twins| {
        let (body, whole) = twins.insert(sleepless(0.0), cube());
        let (other, _) = twins.insert(sleepless(9.0), cube());
        let part = twins.insert_part(body, cuboid([0.1; 3]).translation(at(0.5, 0.0)));
        assert!(!twins.steps(STEPS).touches(whole, part));
        for parent in [other, body, other] {
            twins.set_parent(part, Some(parent));
            twins.both(|world| {
                let (bodies, colliders) = (&mut world.bodies, &mut world.colliders);
                // It stays where it is.
                let x = if parent == other { -8.5 } else { 0.5 };
                colliders[part].set_translation_wrt_parent(at(x, 0.0));
                bodies[body].set_translation(at(0.0, 0.0), true);
                bodies[other].set_translation(at(9.0, 0.0), true);
            });
            assert_eq!(twins.step().touches(whole, part), parent == other);
            twins.steps(STEPS);
        }
    });
}

#[test]
fn collision_types() {
    for_each_filter(|mut twins| {
        let (_, left) = twins.insert(fixed(0.0, 0.0), cube());
        let (_, right) = twins.insert(fixed(0.9, 0.0), cube());
        assert!(!twins.steps(STEPS).touches(left, right));
        for (types, x) in [
            (ActiveCollisionTypes::all(), 0.01),
            (ActiveCollisionTypes::empty(), 0.0),
            (ActiveCollisionTypes::FIXED_FIXED, 0.01),
        ] {
            twins.change(left, |left| {
                left.set_active_collision_types(types);
                // Rapier looks at the types again when the collider moves.
                left.set_translation_wrt_parent(at(x, 0.0));
            });
            let touches = !types.is_empty();
            assert_eq!(twins.step().touches(left, right), touches);
            assert_eq!(twins.steps(STEPS).touches(left, right), touches);
        }
    });
}

#[test]
fn groups() {
    for_each_filter(|mut twins| {
        let (_, left) = twins.insert(sleepless(0.0), cube());
        let (_, right) = twins.insert(sleepless(0.999), cube());
        assert!(twins.steps(STEPS).touches(left, right));
        for (groups, touches) in [
            (InteractionGroups::none(), false),
            (InteractionGroups::all(), true),
        ] {
            twins.change(right, |right| right.set_collision_groups(groups));
            assert_eq!(twins.step().touches(left, right), touches);
            twins.steps(STEPS);
        }
    });
}

#[test]
fn sensors() {
    for_each_filter(|mut twins| {
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

#[test]
fn enabling() {
    for_each_filter(|mut twins| {
        let (body, left) = twins.insert(sleepless(0.0), cube());
        let (_, right) = twins.insert(fixed(0.999, 0.0), cube());
        assert!(twins.steps(STEPS).touches(left, right));
        for enabled in [false, true] {
            twins.change(left, |left| left.set_enabled(enabled));
            twins.change_body(body, |body| body.set_translation(at(0.0, 0.0), true));
            assert_eq!(twins.step().touches(left, right), enabled);
            twins.steps(STEPS);
        }
        for enabled in [false, true] {
            twins.change_body(body, |body| {
                body.set_enabled(enabled);
                body.set_translation(at(0.0, 0.0), true);
            });
            assert_eq!(twins.step().touches(left, right), enabled);
            twins.steps(STEPS);
        }
    });
}

/// What was left out may have moved in the meantime, here or there.
#[test]
fn moves_while_it_is_left_out() {
    for_each_filter(|mut twins| {
        let (body, left) = twins.insert(sleepless(0.0), cube());
        let (_, right) = twins.insert(fixed(0.95, 0.0), cube());
        let [none, all] = [InteractionGroups::none(), InteractionGroups::all()];
        for (groups, x, touches) in [
            (none, 0.0, false),
            (none, -5.0, false),
            (all, -5.0, false),
            (all, 0.0, true),
            (none, -5.0, false),
            (none, 0.0, false),
            (all, 0.0, true),
        ] {
            twins.change(left, |left| left.set_collision_groups(groups));
            twins.change_body(body, |body| {
                body.set_linvel(at(0.0, 0.0), true);
                body.set_translation(at(x, 0.0), true);
            });
            assert_eq!(twins.step().touches(left, right), touches);
            twins.steps(STEPS);
        }
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
        let stats = twins.unisize.stats();
        assert!(stats.candidates >= stats.pairs);
        stats.pairs
    };
    assert_eq!(pairs_with(PairFilter::Off), 6);
    assert_eq!(pairs_with(PairFilter::Bodies), 3);
    assert_eq!(pairs_with(PairFilter::Groups), 1);
    assert_eq!(pairs_with(PairFilter::Shapes), 0);
}
