//! Rapier 0.36, whose pipeline sets the boxes of moved colliders one by one, and lists only colliders that the user has changed,
//! here none.

use rapier2d_036 as rapier;

#[path = "world.rs"]
mod world;

use super::NAMES;
use rapier::prelude::*;
use unisize_charts::{RGBColor, color};
pub(super) use world::Hierarchy;
use world::World;

const NAME: &str = NAMES[1];
const COLOR: RGBColor = color::MINT;

fn introduce(broad_phase: &mut DefaultBroadPhase, world: &mut World) {
    broad_phase.update(
        &world.params,
        &world.colliders,
        &world.bodies,
        &world.listed,
        &[],
        &mut world.events,
    );
}

fn update(broad_phase: &mut DefaultBroadPhase, world: &mut World) {
    let distance = world.params.prediction_distance() / 2.0;
    for &handle in &world.listed {
        let aabb = world.colliders[handle].compute_collision_aabb(distance);
        broad_phase.set_aabb(&world.params, handle, aabb);
    }
    broad_phase.update(
        &world.params,
        &world.colliders,
        &world.bodies,
        &[],
        &[],
        &mut world.events,
    );
}
