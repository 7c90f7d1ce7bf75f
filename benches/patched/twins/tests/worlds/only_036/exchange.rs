//! A broad phase that takes the place of another in a running world.

use super::physics_world::unisize;
use super::rapier::geometry::CustomBroadPhase;
use super::rapier::parry;
use super::rapier::prelude::*;
use super::snapshot::{EventLog, contacts};
use super::twins::{Twins, at, cube, cuboid, dynamic};
use super::{PairFilter, Settings, Trial, UnisizeBroadPhase, install};

/// How many cubes rest on a floor, one on top of the other.
const CUBES: usize = 4;

fn world_on(broad_phase: DefaultBroadPhase) -> PhysicsWorld {
    let mut world = PhysicsWorld {
        broad_phase,
        ..PhysicsWorld::default()
    };
    world.insert(RigidBodyBuilder::fixed(), cuboid([10.0, 0.5, 10.0]));
    world
}

/// A column of cubes that has come to rest, and its bodies.
fn column(broad_phase: DefaultBroadPhase) -> (PhysicsWorld, Vec<RigidBodyHandle>) {
    let mut world = world_on(broad_phase);
    let cubes = (0..CUBES).map(|i| world.insert(dynamic(0.0, 1.0 + i as Real), cube()).0);
    let cubes = cubes.collect();
    run(&mut world);
    (world, cubes)
}

/// Until all sleep.
fn run(world: &mut PhysicsWorld) {
    for _ in 0..200 {
        world.step();
    }
}

fn ours() -> DefaultBroadPhase {
    DefaultBroadPhase::custom(UnisizeBroadPhase::new())
}

/// Ours with other settings.
fn other() -> DefaultBroadPhase {
    let settings = Settings::default()
        .with_filter(PairFilter::Groups)
        .with_margin(0.05);
    DefaultBroadPhase::custom(UnisizeBroadPhase::with_settings(settings))
}

/// Panics unless a column that was `changed` goes on resting, with the contacts that it had, and stands when it is woken.
fn stands(broad_phase: DefaultBroadPhase, change: impl FnOnce(PhysicsWorld) -> PhysicsWorld) {
    let (world, cubes) = column(broad_phase);
    let heights = |world: &PhysicsWorld| {
        let height = |&cube: &RigidBodyHandle| world.bodies[cube].translation().y;
        cubes.iter().map(height).collect::<Vec<_>>()
    };
    let sleep = |world: &PhysicsWorld| cubes.iter().all(|&cube| world.bodies[cube].is_sleeping());
    let (rest, touching) = (heights(&world), contacts(&world.narrow_phase));
    assert!(sleep(&world));
    assert_eq!(touching.len(), CUBES);
    let mut world = change(world);
    let log = EventLog::default();
    world.step_with_events(&(), &log);
    assert_eq!(contacts(&world.narrow_phase), touching);
    assert!(log.0.into_inner().unwrap().is_empty());
    assert!(sleep(&world));
    for &cube in &cubes {
        world.bodies[cube].wake_up(true);
    }
    run(&mut world);
    assert_eq!(contacts(&world.narrow_phase), touching);
    let mut heights = heights(&world).into_iter().zip(rest);
    assert!(heights.all(|(now, then)| (now - then).abs() < 0.01));
}

#[test]
fn what_rests_goes_on_resting_on_another_broad_phase() {
    let default = DefaultBroadPhase::new;
    for [before, after] in [[default(), ours()], [ours(), default()], [ours(), other()]] {
        stands(before, |world| PhysicsWorld {
            broad_phase: after,
            ..world
        });
    }
}

/// Some contacts of a settled wall are active although the boxes have parted: Rapier looks at a pair again only once it has moved.
#[test]
fn a_wall_sleeps_on() {
    let mut settled = world_on(ours());
    for i in 0..200 {
        let (row, column) = (i / 10, i % 10);
        let x = 1.02 * column as Real + 0.51 * (row % 2) as Real - 5.0;
        settled.insert(dynamic(x, 1.0 + row as Real), cube());
    }
    for _ in 0..600 {
        settled.step();
    }
    let asleep = |world: &PhysicsWorld| {
        let bodies = world.bodies.iter().filter(|(_, body)| body.is_sleeping());
        bodies.count()
    };
    assert!(asleep(&settled) > 190);
    let (sleepers, touching) = (asleep(&settled), contacts(&settled.narrow_phase));
    let on = |broad_phase, world| PhysicsWorld {
        broad_phase,
        ..world
    };
    let [first, second] = saved(&settled);
    let [third, fourth] = saved(&settled).map(|world| on(ours(), world));
    let exchanged = on(DefaultBroadPhase::new(), settled);
    for mut world in [first, second, third, fourth, exchanged] {
        world.step();
        assert_eq!(asleep(&world), sleepers);
        assert_eq!(contacts(&world.narrow_phase), touching);
    }
}

/// However far Rapier is told that bodies may move before their contacts are computed again, and whether the boxes have parted or not.
#[test]
fn a_cube_sleeps_on_beside_a_wall_that_it_has_left() {
    for distance in [0.05, 0.0, -1.0, Real::NAN, Real::INFINITY, Real::MAX] {
        for make in [DefaultBroadPhase::new, ours, other] {
            let mut world = PhysicsWorld {
                gravity: Default::default(),
                ..world_on(ours())
            };
            world
                .integration_parameters
                .normalized_contact_recycle_distance = distance;
            let (cube, _) = world.insert(dynamic(0.0, 1.0), cube());
            world.step();
            world.bodies[cube].set_translation(at(0.0, 1.03), false);
            run(&mut world);
            let touching = contacts(&world.narrow_phase);
            assert_eq!(touching.len(), usize::from(distance > 0.0));
            world.broad_phase = make();
            world.step();
            assert_eq!(world.broad_phase.bvh().leaf_count(), 2);
            // No finite box is looser by more.
            if distance.is_nan() || distance < 1.0 {
                assert!(world.bodies[cube].is_sleeping());
                assert_eq!(contacts(&world.narrow_phase), touching);
            }
        }
    }
}

/// As it is done where the pipelines do not help.
#[test]
fn a_new_narrow_phase_and_a_list_of_all_do_as_well() {
    let (mut world, cubes) = column(DefaultBroadPhase::new());
    world.broad_phase = ours();
    world.narrow_phase = NarrowPhase::new();
    UnisizeBroadPhase::mark_all_modified(&mut world.colliders);
    run(&mut world);
    assert_eq!(contacts(&world.narrow_phase).len(), CUBES);
    let mut heights = cubes.iter().map(|&cube| world.bodies[cube].translation().y);
    assert!(heights.all(|height| height > 0.9));
}

/// What moves as well: another one in its place knows no collider, as another one of Rapier's does not.
#[test]
fn another_one_in_the_midst_of_a_simulation() {
    let mut twins = Twins::heavy();
    twins.insert_floor();
    twins.insert(dynamic(0.0, 3.0), cube());
    twins.steps(5);
    twins.unisize = install(UnisizeBroadPhase::new());
    twins.default = DefaultBroadPhase::new();
    twins.steps(140);
}

/// A world that was written and read, in a format that tells fields by name, and in one that does not.
fn saved(world: &PhysicsWorld) -> [PhysicsWorld; 2] {
    let json = serde_json::to_string(world).unwrap();
    let bytes = postcard::to_stdvec(world).unwrap();
    [
        serde_json::from_str(&json).unwrap(),
        postcard::from_bytes(&bytes).unwrap(),
    ]
}

/// On unisize or not, and off it or not: what is read has Rapier's own broad phase until it gets another.
#[test]
fn a_saved_world_goes_on() {
    for format in 0..2 {
        let read = |world: PhysicsWorld| saved(&world).into_iter().nth(format).unwrap();
        for make in [DefaultBroadPhase::new, ours, other] {
            stands(make(), read);
            stands(make(), |world| PhysicsWorld {
                broad_phase: ours(),
                ..read(world)
            });
        }
    }
}

/// Changes that list colliders although no broad phase reads them, in the step of the exchange: of the floor alone, and of all colliders.
#[test]
fn colliders_that_change_otherwise_are_not_lost() {
    let changes: [fn(&mut ColliderSet); 3] = [
        |colliders| {
            let (floor, _) = colliders.iter().next().unwrap();
            colliders[floor].set_friction(0.3);
        },
        |colliders| {
            for (_, collider) in colliders.iter_mut() {
                collider.user_data = 7;
            }
        },
        // As after collisions were detected by hand: they have flags, and nothing lists them.
        |colliders| {
            for (_, collider) in colliders.iter_mut() {
                collider.user_data = 7;
            }
            colliders.take_modified();
        },
    ];
    let default = DefaultBroadPhase::new;
    for change in changes {
        for [before, after] in [[default(), ours()], [ours(), default()], [ours(), other()]] {
            stands(before, |mut world| {
                change(&mut world.colliders);
                world.broad_phase = after;
                world
            });
        }
        stands(ours(), |world| {
            let [mut world, _] = saved(&world);
            change(&mut world.colliders);
            world
        });
    }
}

/// Although each collider moves in the step of the exchange, so that the new broad phase would read them all.
#[test]
fn pairs_of_the_former_broad_phase_end() {
    for make in [DefaultBroadPhase::new, ours] {
        let (mut world, _) = column(ours());
        for (i, (_, collider)) in world.colliders.iter_mut().enumerate() {
            collider.set_position(Pose::from_translation(at(100.0 * i as Real, 0.0)));
        }
        for (i, (_, body)) in world.bodies.iter_mut().enumerate() {
            body.set_translation(at(100.0 * i as Real, 0.0), true);
        }
        world.broad_phase = make();
        world.step();
        assert_eq!(world.narrow_phase.contact_pairs().count(), 0);
    }
}

/// In the midst of motion, and as often as somebody likes.
#[test]
fn a_world_is_saved_again_and_again() {
    let mut world = world_on(ours());
    for i in 0..20 {
        let ball = ColliderBuilder::ball(0.3);
        world.insert(dynamic(0.1 * (i % 3) as Real, 1.0 + 0.7 * i as Real), ball);
    }
    for round in 0..30 {
        for _ in 0..7 {
            world.step();
            let deepest = deepest(&world);
            // A quarter of a ball: what falls fast sinks in that far without being saved, too.
            assert!(deepest < 0.15, "two overlap by {deepest} in round {round}");
        }
        let [read, _] = saved(&world);
        world = read;
        if round % 3 > 0 {
            world.broad_phase = ours();
        }
    }
    assert!(contacts(&world.narrow_phase).len() > 10);
}

/// By how much two colliders overlap at most.
fn deepest(world: &PhysicsWorld) -> Real {
    let all: Vec<_> = world.colliders.iter().collect();
    let mut deepest = 0.0;
    for (i, (_, a)) in all.iter().enumerate() {
        for (_, b) in &all[i + 1..] {
            let contact =
                parry::query::contact(a.position(), a.shape(), b.position(), b.shape(), 0.0);
            let distance = contact.unwrap().map_or(0.0, |contact| contact.dist);
            deepest = Real::max(deepest, -distance);
        }
    }
    deepest
}

/// A broad phase that has been updated is not new: nothing is listed for it, and its pairs stay.
#[test]
fn a_broad_phase_that_knows_the_world_is_left_alone() {
    let (mut world, _) = column(ours());
    let known = world.broad_phase.clone();
    let before = unisize(&world).stats();
    world.broad_phase = known;
    world.step();
    let after = unisize(&world).stats();
    assert_eq!((before.pairs, before.updates), (after.pairs, after.updates));
}

/// Its counts go on.
#[test]
fn a_cleared_broad_phase_receives_all_colliders_again() {
    let (mut world, _) = column(ours());
    let before = unisize(&world).stats();
    let cleared = world.broad_phase.custom_mut::<UnisizeBroadPhase>().unwrap();
    cleared.clear();
    cleared.validate();
    assert_eq!((cleared.pairs().count(), cleared.stats().pairs), (0, 0));
    world.step();
    let after = unisize(&world).stats();
    assert_eq!(
        (before.pairs, before.updates + 1),
        (after.pairs, after.updates)
    );
}

/// Clones of sets and broad phase belong together, in a world that goes back and in another one.
#[test]
fn a_broad_phase_that_is_put_back_with_its_sets_is_left_alone() {
    let (mut world, _) = column(ours());
    let saved = || {
        (
            world.broad_phase.clone(),
            world.bodies.clone(),
            world.colliders.clone(),
        )
    };
    let [back, other] = [saved(), saved()];
    let islands = world.islands.clone();
    world.step();
    let (broad_phase, bodies, colliders) = other;
    let other = PhysicsWorld {
        broad_phase,
        bodies,
        colliders,
        islands: islands.clone(),
        narrow_phase: world.narrow_phase.clone(),
        ..PhysicsWorld::default()
    };
    (world.broad_phase, world.bodies, world.colliders) = back;
    world.islands = islands;
    for mut world in [world, other] {
        let before = unisize(&world).stats();
        world.step();
        let after = unisize(&world).stats();
        assert_eq!((before.pairs, before.updates), (after.pairs, after.updates));
    }
}

#[test]
fn it_is_found_by_its_own_type_only() {
    let mut ours = ours();
    assert!(ours.custom_ref::<UnisizeBroadPhase>().is_some());
    assert!(ours.custom_mut::<UnisizeBroadPhase>().is_some());
    assert!(ours.custom_ref::<Trial>().is_none());
    assert!(ours.custom_mut::<Trial>().is_none());
    assert!(DefaultBroadPhase::new().custom_ref::<Trial>().is_none());
}
