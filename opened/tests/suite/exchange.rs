//! A broad phase that takes the place of another in a running world.

use super::rapier::prelude::*;
use super::twins::{cube, cuboid, dynamic};
use super::{PairFilter, Settings, UnisizeBroadPhase};

/// How many cubes rest on a floor, one on top of the other.
const CUBES: usize = 4;

/// A column of cubes that has come to rest, and its bodies.
fn column(broad_phase: DefaultBroadPhase) -> (PhysicsWorld, Vec<RigidBodyHandle>) {
    let mut world = PhysicsWorld {
        broad_phase,
        ..PhysicsWorld::default()
    };
    world.insert(RigidBodyBuilder::fixed(), cuboid([10.0, 0.5, 10.0]));
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

fn exchanges() -> [[DefaultBroadPhase; 2]; 3] {
    let default = DefaultBroadPhase::new;
    let ours = || DefaultBroadPhase::custom(UnisizeBroadPhase::new());
    let settings = Settings::default()
        .with_filter(PairFilter::Groups)
        .with_margin(0.05);
    let other = DefaultBroadPhase::custom(UnisizeBroadPhase::with_settings(settings));
    [[default(), ours()], [ours(), default()], [ours(), other]]
}

/// Whether a column stands after its broad phase and its narrow phase were exchanged.
fn stands([before, after]: [DefaultBroadPhase; 2], are_listed: bool) -> bool {
    let (mut world, cubes) = column(before);
    let heights = |world: &PhysicsWorld| {
        let height = |&cube: &RigidBodyHandle| world.bodies[cube].translation().y;
        cubes.iter().map(height).collect::<Vec<_>>()
    };
    let rest = heights(&world);
    assert!(cubes.iter().all(|&cube| world.bodies[cube].is_sleeping()));
    world.broad_phase = after;
    world.narrow_phase = NarrowPhase::new();
    if are_listed {
        UnisizeBroadPhase::list_all(&mut world.colliders);
    }
    // What sleeps is not listed later, either.
    world.step();
    for &cube in &cubes {
        world.bodies[cube].wake_up(true);
    }
    run(&mut world);
    let contacts = world.narrow_phase.contact_pairs();
    let contacts = contacts
        .filter(|pair| pair.has_any_active_contact())
        .count();
    let mut heights = heights(&world).into_iter().zip(rest);
    let stands = heights.all(|(now, then)| (now - then).abs() < 0.01);
    assert_eq!(stands, contacts == CUBES);
    stands
}

#[test]
fn what_rests_goes_on_resting_on_another_broad_phase() {
    for exchange in exchanges() {
        assert!(stands(exchange, true));
    }
}

/// Otherwise there would be nothing to list.
#[test]
fn what_is_not_listed_falls() {
    for exchange in exchanges() {
        assert!(!stands(exchange, false));
    }
}
