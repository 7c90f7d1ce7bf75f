//! What users of other engines have reported as defects: much that changes at once, or again and again.

use std::collections::BTreeSet;
use std::ops::Range;

use super::rapier::parry::bounding_volume::BoundingVolume;
use super::rapier::prelude::*;
use super::scenes::Vector;
use super::snapshot::{Event, EventLog, Snapshot, pair};
use super::twins::{Twins, at, cube, cuboid, dynamic, fixed, triple};
use super::version;
use super::{Installed, PairFilter, Settings, Steppable, UnisizeBroadPhase, World, install};

/// Balls without bodies, which meet all, and a broad phase that is compared with all pairs of them.
struct Compared {
    world: World,
    unisize: Installed<UnisizeBroadPhase>,
    balls: Vec<ColliderHandle>,
}

impl Compared {
    /// Rows of balls that touch their neighbours.
    fn new() -> Self {
        let settings = Settings::default().with_filter(PairFilter::Groups);
        let mut compared = Self {
            world: World::new(at(0.0, 0.0)),
            unisize: install(UnisizeBroadPhase::with_settings(settings)),
            balls: Vec::new(),
        };
        for i in 0..30 {
            compared.insert(at(0.9 * (i % 6) as Real, 0.9 * (i / 6) as Real));
        }
        compared.check();
        compared
    }

    fn insert(&mut self, place: Vector) {
        let ball = ColliderBuilder::ball(0.5)
            .translation(place)
            .active_collision_types(ActiveCollisionTypes::all());
        self.balls.push(self.world.colliders.insert(ball));
    }

    /// Moves the ball of this number.
    fn place(&mut self, ball: usize, place: Vector) {
        self.world.colliders[self.balls[ball]].set_translation(place);
    }

    /// Updates the pairs. Every two enabled colliders must be one whose boxes overlap, and none whose boxes are far apart.
    fn check(&mut self) {
        self.world
            .collide(self.unisize.for_step(), &EventLog::default());
        self.unisize.validate();
        let pairs = self.unisize.pairs();
        let held: BTreeSet<_> = pairs.map(|it| pair(it.collider1, it.collider2)).collect();
        let enabled = self.world.colliders.iter_enabled();
        let enabled = enabled.map(|(handle, collider)| (handle, collider.compute_aabb()));
        let enabled: Vec<_> = enabled.collect();
        let mut expected = 0;
        for (i, (a, box_a)) in enabled.iter().enumerate() {
            for (b, box_b) in &enabled[..i] {
                let is_held = held.contains(&pair(*a, *b));
                expected += usize::from(is_held);
                assert!(is_held || !box_a.intersects(box_b), "{a:?} and {b:?}");
                let is_near = box_a.loosened(0.1).intersects(&box_b.loosened(0.1));
                assert!(is_near || !is_held, "{a:?} and {b:?} are apart");
            }
        }
        assert_eq!(expected, held.len(), "pairs of what is not enabled");
    }
}

#[test]
fn what_is_disabled_and_enabled_many_times_in_a_row() {
    let mut compared = Compared::new();
    for round in 0..12 {
        let chosen = compared.balls.iter().skip(round % 3).step_by(3);
        for &ball in chosen {
            let ball = &mut compared.world.colliders[ball];
            // Several times before an update, or once.
            for _ in 0..round / 4 {
                ball.set_enabled(false);
                ball.set_enabled(true);
            }
            ball.set_enabled(round % 2 == 1);
        }
        compared.check();
    }
    for &ball in &compared.balls {
        compared.world.colliders[ball].set_enabled(true);
    }
    compared.check();
}

#[test]
fn what_is_nowhere_among_what_is_sound() {
    let mut compared = Compared::new();
    for round in 0..20 {
        let nowhere = triple([Real::NAN; 3]);
        compared.place(7, if round % 5 < 3 { nowhere } else { at(1.0, 1.0) });
        for i in (8..30).step_by(2) {
            compared.place(i, at(0.7 * (i + round) as Real % 5.0, 0.3 * i as Real));
        }
        compared.check();
    }
}

#[test]
fn all_is_removed_and_added_between_two_updates() {
    let mut compared = Compared::new();
    for round in 0..6 {
        for ball in std::mem::take(&mut compared.balls) {
            compared.world.remove_collider(ball);
        }
        for i in 0..20 + round {
            compared.insert(at(0.8 * (i % 5) as Real, 0.8 * (i / 5) as Real));
        }
        compared.check();
    }
    let mut twins = Twins::heavy();
    twins.insert_floor();
    let place = |i: usize| at(2.0 * i as Real, 0.5);
    for round in 0..6 {
        let cubes = (0..30 + round).map(|i| {
            let body = RigidBodyBuilder::dynamic().translation(place(i));
            twins.insert(body, cube()).0
        });
        let cubes: Vec<_> = cubes.collect();
        assert!(twins.steps(3).contacts.len() >= cubes.len());
        cubes.into_iter().for_each(|cube| twins.remove(cube));
    }
    assert!(twins.step().contacts.is_empty());
}

/// Plays a number of steps. Returns the events of each in the order in which they came.
fn play(
    world: &mut World,
    unisize: &mut Installed<UnisizeBroadPhase>,
    steps: usize,
) -> Vec<Vec<Event>> {
    let steps = (0..steps).map(|_| {
        let log = EventLog::default();
        world.step(unisize.for_step(), &(), &log);
        log.0.into_inner().expect("no handler panics")
    });
    steps.collect()
}

#[test]
fn a_world_that_goes_back_repeats_its_events_in_order() {
    let mut world = World::new(at(0.0, -9.81));
    let mut unisize = install(UnisizeBroadPhase::new());
    let events = ActiveEvents::COLLISION_EVENTS;
    let floor = cuboid([50.0, 1.0, 50.0]).translation(at(0.0, -1.0));
    world.insert(RigidBodyBuilder::fixed(), floor);
    for i in 0..36 {
        let place = [
            1.1 * (i % 6) as Real + 0.04 * i as Real,
            1.5 * (i / 6) as Real + 1.0,
        ];
        world.insert(dynamic(place[0], place[1]), cube().active_events(events));
    }
    let mut count = 0;
    for _ in 0..8 {
        play(&mut world, &mut unisize, 15);
        let mut former = World {
            params: world.params,
            islands: world.islands.clone(),
            narrow_phase: world.narrow_phase.clone(),
            bodies: world.bodies.clone(),
            colliders: world.colliders.clone(),
            impulse_joints: world.impulse_joints.clone(),
            multibody_joints: world.multibody_joints.clone(),
            ccd_solver: world.ccd_solver.clone(),
            ..World::new(world.gravity)
        };
        let broad_phase: &UnisizeBroadPhase = &unisize;
        let mut kept = install(broad_phase.clone());
        let first = play(&mut world, &mut unisize, 20);
        count += first.iter().flatten().count();
        assert_eq!(play(&mut former, &mut kept, 20), first);
        (world, unisize) = (former, kept);
    }
    assert!(count > 36, "only {count} events");
}

#[test]
fn a_large_sensor_that_moves() {
    let mut twins = Twins::weightless();
    let body = RigidBodyBuilder::kinematic_velocity_based()
        .translation(at(-30.0, 0.0))
        .linvel(at(20.0, 0.5));
    twins.insert(body, cuboid([12.0; 3]).sensor(true));
    for i in 0..40 {
        let [x, y] = [2.5 * (i % 8) as Real, 2.5 * (i / 8) as Real];
        twins.insert(
            dynamic(x, y).can_sleep(i % 2 == 0),
            ColliderBuilder::ball(0.5),
        );
    }
    let mut most = 0;
    for _ in 0..200 {
        most = most.max(twins.step().intersections.len());
    }
    assert!(most >= 30, "at most {most} at once");
    assert!(twins.step().intersections.len() < most);
}

#[test]
fn what_carried_sleepers_goes_away() {
    for removes in [false, true] {
        let mut twins = Twins::heavy();
        let (floor, _) = twins.insert(fixed(0.0, -1.0), cuboid([100.0, 1.0, 100.0]));
        let sleepers = (0..12).map(|i| twins.insert(dynamic(3.0 * i as Real, 0.5), cube()).0);
        let sleepers: Vec<_> = sleepers.collect();
        twins.step_until(|seen| sleepers.iter().all(|&body| seen.sleeps(body)));
        match removes {
            true => twins.remove(floor),
            false => twins.change_body(floor, |floor| floor.set_translation(at(0.0, -50.0), true)),
        }
        let seen = twins.steps(60);
        assert!(sleepers.iter().all(|&body| seen.height(body) < -1.0));
    }
}

#[test]
fn voxels_are_dug_away_and_put_back() {
    let mut twins = Twins::heavy();
    // One row alone: in debug builds, Parry 0.22 panics at the others.
    let voxels = |columns: Range<usize>| columns.map(|x| version::voxel([x as Real, -1.0, 0.0]));
    let ground = ColliderBuilder::voxels(triple([1.0; 3]), &voxels(0..24).collect::<Vec<_>>());
    let ground = ground.translation(triple([0.0, 0.0, -0.5]));
    let (_, ground) = twins.insert(RigidBodyBuilder::fixed(), ground);
    let drop_cube = |twins: &mut Twins, x| twins.insert(dynamic(x, 0.5), cube());
    let cubes: Vec<_> = (0..6)
        .map(|i| drop_cube(&mut twins, 4.0 * i as Real + 1.5))
        .collect();
    let seen = twins.steps(20);
    let touch = |seen: &Snapshot, cube: usize| seen.touches(cubes[cube].1, ground);
    assert!((0..6).all(|cube| touch(&seen, cube)));
    let edit = |twins: &mut Twins, columns: Range<usize>, is_filled| {
        twins.change(ground, |ground| {
            let shape = ground.shape_mut().as_voxels_mut();
            let shape = shape.expect("it is of voxels");
            for voxel in voxels(columns.clone()) {
                shape.set_voxel(voxel, is_filled);
            }
        });
    };
    // The ground under two cubes goes, in its middle and at its end.
    for (cube, columns) in [(2, 8..12), (5, 20..24)] {
        edit(&mut twins, columns, false);
        let seen = twins.steps(30);
        assert!(!touch(&seen, cube) && seen.height(cubes[cube].0) < -0.5);
        assert!([0, 1, 3].iter().all(|&cube| touch(&seen, cube)));
    }
    // It comes back, and goes on where its box did not reach.
    edit(&mut twins, 8..32, true);
    let others = [9.5, 21.5, 30.5].map(|x| drop_cube(&mut twins, x).1);
    let seen = twins.steps(30);
    assert!(others.iter().all(|&cube| seen.touches(cube, ground)));
}

#[test]
fn the_origin_is_shifted() {
    let mut twins = Twins::heavy();
    let mut bodies = vec![twins.insert_floor().0];
    for i in 0..20 {
        bodies.push(twins.insert(dynamic(3.0 * i as Real, 0.6), cube()).0);
    }
    for round in 0..6 {
        twins.steps(30);
        let by = at([512.0, -1024.0, 512.0][round % 3], 256.0);
        for &body in &bodies {
            let is_woken = round % 2 == 0;
            twins.change_body(body, |body| {
                let place = version::origin(body.position()) + by;
                body.set_translation(place, is_woken);
            });
        }
    }
    assert_eq!(twins.steps(30).contacts.len(), 20);
}

#[test]
fn many_bullets_in_each_frame_and_a_ray_for_each() {
    let mut twins = Twins::weightless();
    let (_, wall) = twins.insert(fixed(5.0, 0.0), cuboid([0.5, 500.0, 30.0]));
    let (mut hits, mut frames) = (0, Vec::new());
    for frame in 0..12 {
        let bullets = (0..200).map(|lane| {
            let bullet = dynamic(0.1 * (lane % 7) as Real, 2.0 * lane as Real - 200.0);
            let bullet = bullet.linvel(at(90.0, 0.0)).ccd_enabled(lane % 5 == 0);
            twins.insert(bullet, ColliderBuilder::ball(0.1)).0
        });
        frames.push(bullets.collect::<Vec<_>>());
        twins.step();
        for lane in 0..200 {
            let origin = at(-1.0, 2.0 * lane as Real - 200.0);
            let ray = Ray::new(origin.into(), at(1.0, 0.0));
            let hit = twins.same(|scene| scene.cast_ray(&ray, 100.0, true));
            hits += usize::from(hit.is_some_and(|(hit, _)| hit != wall));
        }
        // They are gone before the next ones come as far.
        if frame % 2 == 1 {
            for bullet in std::mem::take(&mut frames).into_iter().flatten() {
                twins.remove(bullet);
            }
        }
    }
    assert!(hits > 1_000, "only {hits} hits");
}

/// Every two boxes overlap at once, and in the next step none do.
#[test]
fn all_is_at_the_origin_and_then_dispersed() {
    for filter in [version::LEVEL_OF_OWN, PairFilter::Shapes] {
        let mut twins = Twins::with_filter(filter).without_gravity();
        let bodies = (0..60).map(|i| {
            let body = RigidBodyBuilder::dynamic().can_sleep(i % 4 == 0);
            let shape = match i % 3 {
                0 => ColliderBuilder::ball(0.5),
                1 => ColliderBuilder::capsule_y(0.3, 0.2),
                _ => cube(),
            };
            // No force, so that no order matters.
            let shape = shape.solver_groups(InteractionGroups::none());
            twins.insert(body, shape).0
        });
        let bodies: Vec<_> = bodies.collect();
        for round in 1..4 {
            assert_eq!(twins.steps(2).contacts.len(), 60 * 59 / 2);
            for (i, &body) in bodies.iter().enumerate() {
                let place = at((i % 8) as Real, (i / 8) as Real) * (2 * round) as Real;
                twins.change_body(body, |body| body.set_translation(place, i % 2 == 0));
            }
            assert_eq!(twins.steps(2).contacts.len(), 0);
            for &body in &bodies {
                twins.change_body(body, |body| body.set_translation(at(0.0, 0.0), true));
            }
        }
    }
}
