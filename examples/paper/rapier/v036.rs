//! Rapier 0.36, whose pipeline sets the boxes of what has moved one by one, and updates with a list of what the user has
//! changed, which is empty here.

use rapier2d_0_36 as rapier;

#[path = "world.rs"]
mod world;

use super::NAMES;
use plotters::style::RGBColor;
use rapier::prelude::*;
pub(super) use world::Hierarchy;
use world::World;

const NAME: &str = NAMES[1];
const COLOR: RGBColor = RGBColor(110, 200, 130);

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
