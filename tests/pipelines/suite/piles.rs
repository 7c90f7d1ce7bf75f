//! Piles: bodies that touch many others. The order of contacts matters to the solver, so only the outcome is
//! compared.

use super::rapier::prelude::*;
use super::twins::{at, cube, cuboid};
use super::{UnisizeBroadPhase, World};

/// Drops cubes into a box; all must come to rest inside, at a sound depth.
fn settle(broad_phase: &mut dyn BroadPhase) -> usize {
    let mut world = World::new(at(0.0, -9.81));
    let floor = cuboid([50.0, 1.0, 50.0]).translation(at(0.0, -1.0));
    world.colliders.insert(floor);
    for side in [-1.0, 1.0] {
        let wall = cuboid([0.5, 20.0, 20.0]).translation(at(4.0 * side, 15.0));
        world.colliders.insert(wall);
    }
    let mut cubes = Vec::new();
    for row in 0..6 {
        for column in 0..5 {
            let (x, y) = (1.2 * column as Real - 2.4, 1.1 * row as Real + 0.6);
            let body = RigidBodyBuilder::dynamic().translation(at(x + 0.03 * row as Real, y));
            cubes.push(world.insert(body, cube()));
        }
    }
    for step in 0..2000 {
        world.step(broad_phase, &(), &());
        if cubes.iter().all(|&cube| world.bodies[cube].is_sleeping()) {
            for &cube in &cubes {
                let place = world.bodies[cube].translation();
                assert!(place.y > 0.4 && place.y < 8.0 && place.x.abs() < 50.0);
            }
            return step;
        }
    }
    panic!("the pile does not come to rest");
}

#[test]
fn both_come_to_rest() {
    settle(&mut UnisizeBroadPhase::new());
    settle(&mut DefaultBroadPhase::new());
}
