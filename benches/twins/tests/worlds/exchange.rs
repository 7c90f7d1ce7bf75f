//! A broad phase that takes the place of another in a running world of Rapier 0.27.

use super::rapier::prelude::*;
use super::suite::twins::{at, cube, cuboid, dynamic};
use super::{PairFilter, Settings, UnisizeBroadPhase, World};

/// How many cubes rest on a floor, one on top of the other.
const CUBES: usize = 4;

/// Until all sleep.
fn run(world: &mut World, broad_phase: &mut dyn BroadPhase) {
    for _ in 0..200 {
        world.step(broad_phase, &(), &());
    }
}

/// Whether a column stands after its broad phase and its narrow phase were exchanged.
fn stands([mut before, mut after]: [Box<dyn BroadPhase>; 2], are_listed: bool) -> bool {
    let mut world = World::new(at(0.0, -9.81));
    world.insert(RigidBodyBuilder::fixed(), cuboid([10.0, 0.5, 10.0]));
    let cubes = (0..CUBES).map(|i| world.insert(dynamic(0.0, 1.0 + i as Real), cube()));
    let cubes: Vec<_> = cubes.collect();
    run(&mut world, &mut *before);
    let heights = |world: &World| {
        let height = |&cube: &RigidBodyHandle| world.bodies[cube].translation().y;
        cubes.iter().map(height).collect::<Vec<_>>()
    };
    let rest = heights(&world);
    assert!(cubes.iter().all(|&cube| world.bodies[cube].is_sleeping()));
    world.narrow_phase = NarrowPhase::new();
    if are_listed {
        UnisizeBroadPhase::mark_all_modified(&mut world.colliders);
    }
    // What sleeps is not listed later, either.
    world.step(&mut *after, &(), &());
    for &cube in &cubes {
        world.bodies[cube].wake_up(true);
    }
    run(&mut world, &mut *after);
    let contacts = world.narrow_phase.contact_pairs();
    let contacts = contacts.filter(|pair| pair.has_any_active_contact).count();
    let mut heights = heights(&world).into_iter().zip(rest);
    let stands = heights.all(|(now, then)| (now - then).abs() < 0.01);
    assert_eq!(stands, contacts == CUBES);
    stands
}

/// What is not listed falls, or there would be nothing to list.
#[test]
fn what_rests_goes_on_resting_if_all_are_listed() {
    let default = || Box::new(DefaultBroadPhase::new()) as Box<dyn BroadPhase>;
    let ours = || Box::new(UnisizeBroadPhase::new()) as Box<dyn BroadPhase>;
    let settings = Settings::default().with_filter(PairFilter::Shapes);
    let other = || Box::new(UnisizeBroadPhase::with_settings(settings)) as Box<dyn BroadPhase>;
    for are_listed in [false, true] {
        for exchange in [[default(), ours()], [ours(), default()], [ours(), other()]] {
            assert_eq!(stands(exchange, are_listed), are_listed);
        }
    }
}
