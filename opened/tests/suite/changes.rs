//! What a user changes about a collider or body while it touches another.

use super::rapier::prelude::*;
use super::snapshot::Snapshot;
use super::twins::{Twins, at, cube, cuboid, dynamic, fixed};
use super::{PairFilter, Settings, UnisizeBroadPhase, floors};

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
        let settings = Settings::default().with_filter(filter);
        let mut twins = Twins::with(UnisizeBroadPhase::with_settings(settings));
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
    fn part_and_meet(part: impl Fn(&mut Self), meet: impl Fn(&mut Self)) {
        for filter in [PairFilter::Off, PairFilter::Bodies, PairFilter::Groups] {
            let mut resting = Self::with(filter);
            for _ in 0..3 {
                part(&mut resting);
                let seen = resting.twins.step();
                assert!(!seen.touches(resting.cube, resting.floor));
                resting.twins.steps(2);
                meet(&mut resting);
                let seen = resting.twins.step();
                assert!(seen.touches(resting.cube, resting.floor));
                resting.twins.steps(2);
            }
        }
    }
}

fn groups(bits: Group) -> InteractionGroups {
    InteractionGroups::new(bits, bits, InteractionTestMode::And)
}

#[test]
fn disabled_colliders() {
    Resting::part_and_meet(
        |it| it.twins.change(it.cube, |cube| cube.set_enabled(false)),
        |it| it.twins.change(it.cube, |cube| cube.set_enabled(true)),
    );
    Resting::part_and_meet(
        |it| it.twins.change(it.floor, |floor| floor.set_enabled(false)),
        |it| it.twins.change(it.floor, |floor| floor.set_enabled(true)),
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
    let second = twins.both(|world| world.insert_body(dynamic(0.0, 0.0)));
    assert!(!twins.steps(3).touches(left, right));
    for _ in 0..2 {
        twins.set_parent(right, Some(second));
        assert!(twins.step().touches(left, right));
        twins.set_parent(right, Some(first));
        assert!(!twins.step().touches(left, right));
        for body in [first, second] {
            twins.change_body(body, |body| {
                body.set_position(Pose::IDENTITY, true);
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

/// Rapier's own broad phase looks at the skin again when the collider moves, and not when it is listed for anything else.
#[test]
fn a_skin_counts_from_the_next_move_on() {
    for filter in [PairFilter::Groups, PairFilter::Shapes] {
        let settings = Settings::default().with_filter(filter);
        let mut twins = Twins::with(UnisizeBroadPhase::with_settings(settings)).without_gravity();
        let (wall, left) = twins.insert(fixed(0.0, 0.0), cube());
        let (_, right) = twins.insert(dynamic(1.2, 0.0), cube());
        twins.steps(3);
        twins.change(left, |left| left.set_contact_skin(0.3));
        assert!(!twins.steps(3).touches(left, right));
        twins.change(left, |left| left.set_friction(0.3));
        assert!(!twins.steps(3).touches(left, right));
        twins.change_body(wall, |wall| wall.set_translation(at(0.001, 0.0), true));
        assert!(twins.step().touches(left, right));
    }
}

/// What was changed and changed back within a step is inserted afresh, without a margin, so its pairs end earlier.
#[test]
fn there_and_back() {
    let changes: [fn(&mut PhysicsWorld, RigidBodyHandle, ColliderHandle); 6] = [
        |world, _, collider| {
            let collider = &mut world.colliders[collider];
            let groups = collider.solver_groups();
            collider.set_solver_groups(InteractionGroups::none());
            collider.set_solver_groups(groups);
        },
        |world, _, collider| {
            let collider = &mut world.colliders[collider];
            let groups = collider.collision_groups();
            collider.set_collision_groups(InteractionGroups::none());
            collider.set_collision_groups(groups);
        },
        |world, body, _| {
            world.bodies[body].set_dominance_group(1);
            world.bodies[body].set_dominance_group(0);
        },
        |world, body, _| {
            world.bodies[body].set_body_type(RigidBodyType::Fixed, true);
            world.bodies[body].set_body_type(RigidBodyType::Dynamic, true);
            world.bodies[body].set_linvel(at(0.4, 0.0), true);
        },
        |world, body, collider| {
            let PhysicsWorld {
                colliders, bodies, ..
            } = world;
            colliders.set_parent(collider, None, bodies);
            colliders.set_parent(collider, Some(body), bodies);
        },
        |world, _, collider| {
            world.colliders[collider].set_enabled(false);
            world.colliders[collider].set_enabled(true);
        },
    ];
    let mut ends = Vec::new();
    for change in changes {
        for each in 1..4 {
            let settings = Settings::default().with_filter(PairFilter::Groups);
            let mut twins =
                Twins::with(UnisizeBroadPhase::with_settings(settings)).without_gravity();
            let (_, wall) = twins.insert(fixed(0.0, 0.0), cube());
            let (body, ball) = twins.insert(dynamic(1.0, 0.0), ColliderBuilder::ball(0.5));
            twins.change_body(body, |body| body.set_linvel(at(0.4, 0.0), true));
            let mut end = None;
            for step in 0..60 {
                if step % each == 0 {
                    twins.both(|world| change(world, body, ball));
                }
                twins.step();
                let is_pair =
                    twins.both(|world| world.narrow_phase.contact_pair(wall, ball).is_some());
                if !is_pair {
                    end = end.or(Some(step));
                }
            }
            ends.push(end.expect("it ends"));
        }
    }
    assert!(ends.iter().min() < ends.iter().max(), "{ends:?}");
}

/// On floors that are not simple shapes, each alone on its own.
#[test]
fn floors_of_many_parts() {
    for i in 0..2 {
        let mut twins = Twins::heavy();
        let (_, floor) = twins.insert(RigidBodyBuilder::fixed(), floors(10.0)[i].clone());
        let (body, ball) = twins.insert(dynamic(1.3, 1.0), ColliderBuilder::ball(0.5));
        twins.step_until(|seen| seen.touches(ball, floor));
        twins.steps(60);
        assert!(twins.step().height(body) > 0.3);
    }
}

/// The pipeline without dynamics, which hands nothing over: whatever moves is listed.
#[test]
fn collisions_without_dynamics() {
    let mut twins = Twins::weightless();
    let (_, wall) = twins.insert(fixed(0.0, 0.0), cube());
    let (body, ball) = twins.insert(dynamic(-4.0, 0.0), ColliderBuilder::ball(0.5));
    let mut touching = 0;
    for step in 0..80 {
        twins.change_body(body, |body| {
            body.set_translation(at(-4.0 + 0.1 * step as Real, 0.0), true)
        });
        touching += usize::from(twins.collide().touches(ball, wall));
        if step % 16 == 0 {
            twins.step();
        }
    }
    assert!(touching > 10, "they touch in {touching} steps");
}

/// Who asks a hook wants to be asked about all pairs of boxes, also if what asks rests and was told to by nothing but that.
#[test]
fn hooks_that_are_set_on_what_rests() {
    let mut twins = Twins::weightless();
    let ball = || ColliderBuilder::ball(0.5);
    let (_, still) = twins.insert(fixed(0.0, 0.0), ball());
    let (_, other) = twins.insert(dynamic(0.8, 0.8).can_sleep(false), ball());
    let is_pair = |world: &PhysicsWorld| world.narrow_phase.contact_pair(still, other).is_some();
    twins.steps(3);
    assert!(!is_pair(&twins.ours) && is_pair(&twins.theirs));
    twins.change(still, |still| {
        still.set_active_hooks(ActiveHooks::FILTER_CONTACT_PAIRS)
    });
    twins.steps(2);
    assert!(is_pair(&twins.ours) && is_pair(&twins.theirs));
}
