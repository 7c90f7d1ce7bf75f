//! What no other test covers: several updates per step, NaN poses, a change of broad phase.

use super::rapier::prelude::*;
use super::snapshot::{EventLog, Snapshot};
use super::twins::{Twins, at, cube, cuboid, dynamic};
use super::{UnisizeBroadPhase, World};

#[test]
fn a_step_makes_two_updates() {
    let mut twins = Twins::heavy();
    twins.insert_floor();
    let (body, _) = twins.insert(dynamic(0.0, 0.5), cube());
    for step in 1..10 {
        twins.step();
        // There is nothing to list before the second step and after it.
        assert_eq!(twins.unisize.stats().updates, step + 1);
    }
    twins.change_body(body, |body| body.set_linvel(at(1.0, 0.0), true));
    twins.change_body(body, |body| body.set_translation(at(1.0, 0.5), true));
    twins.step();
    assert_eq!(twins.unisize.stats().updates, 12);
}

/// A floor with cubes far from each other on it.
fn cubes_on_a_floor() -> (World, Vec<RigidBodyHandle>) {
    let mut world = World::new(at(0.0, -9.81));
    world.insert(RigidBodyBuilder::fixed(), cuboid([100.0, 0.5, 100.0]));
    let cubes = (0..6).map(|i| world.insert(dynamic(3.0 * i as Real, 1.0), cube()));
    let cubes = cubes.collect();
    (world, cubes)
}

fn step(world: &mut World, broad_phase: &mut dyn BroadPhase) -> Snapshot {
    let log = EventLog::default();
    world.step(broad_phase, &(), &log);
    Snapshot::of(world, log)
}

#[test]
fn a_pose_that_is_not_a_number_and_back() {
    let mut worlds = [cubes_on_a_floor(), cubes_on_a_floor()];
    let mut broad_phases = [UnisizeBroadPhase::new(), UnisizeBroadPhase::new()];
    let lost = worlds[0].1[2];
    let lost_collider = worlds[0].0.bodies[lost].colliders()[0].into_raw_parts();
    for i in 0..60 {
        if i == 20 {
            let body = &mut worlds[0].0.bodies[lost];
            body.set_translation(at(Real::NAN, Real::NAN), true);
        }
        if i == 40 {
            let body = &mut worlds[0].0.bodies[lost];
            body.set_position(at(6.0, 1.0).into(), true);
            body.set_vels(RigidBodyVelocity::zero(), true);
        }
        let [spoilt, sound] = [0, 1].map(|k| step(&mut worlds[k].0, &mut broad_phases[k]));
        broad_phases[0].validate();
        let is_lost = (20..40).contains(&i);
        assert_eq!(broad_phases[0].stats().refused, usize::from(is_lost));
        let mut expected = sound.contacts.clone();
        if is_lost {
            expected.retain(|pair| !pair.contains(&lost_collider));
        }
        assert_eq!(spoilt.contacts, expected, "at step {i}");
        for (index, pose) in &sound.poses {
            if *index != lost.into_raw_parts().0 {
                assert_eq!(&spoilt.poses[index], pose, "at step {i}");
            }
        }
    }
}

/// A new broad phase knows only the colliders that are listed to it. Setting a collider's position, even to
/// what it is, lists it; Rapier's own broad phase needs no less.
fn list_all(world: &mut World) {
    let handles: Vec<_> = world.colliders.iter().map(|(handle, _)| handle).collect();
    for handle in handles {
        let collider = &mut world.colliders[handle];
        collider.set_position(*collider.position());
    }
}

#[test]
fn another_broad_phase_from_now_on() {
    let [mut swapping, mut staying] = [cubes_on_a_floor().0, cubes_on_a_floor().0];
    let mut default = DefaultBroadPhase::new();
    let mut current: Box<dyn BroadPhase> = Box::new(DefaultBroadPhase::new());
    for i in 0..120 {
        if i % 30 == 20 {
            current = match (i / 30) % 2 {
                0 => Box::new(UnisizeBroadPhase::new()),
                _ => Box::new(DefaultBroadPhase::new()),
            };
            for world in [&mut swapping, &mut staying] {
                list_all(world);
                for (_, body) in world.bodies.iter_mut() {
                    body.apply_impulse(at(0.5, 3.0), true);
                }
            }
        }
        let swapped = step(&mut swapping, &mut *current);
        assert_eq!(swapped, step(&mut staying, &mut default), "at step {i}");
    }
}

#[test]
fn a_clone_goes_on_alike() {
    let (mut first, _) = cubes_on_a_floor();
    let (mut second, _) = cubes_on_a_floor();
    let mut broad_phase = UnisizeBroadPhase::new();
    let mut other = UnisizeBroadPhase::new();
    for i in 0..40 {
        if i == 20 {
            other = broad_phase.clone();
        }
        let seen = step(&mut first, &mut broad_phase);
        assert_eq!(seen, step(&mut second, &mut other), "at step {i}");
    }
}
