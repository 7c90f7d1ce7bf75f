//! Rapier 0.27, whose pipeline lists every collider of an active body in each update.

use rapier2d as rapier;

#[path = "world.rs"]
mod world;

use super::NAMES;
use rapier::prelude::*;
use unisize_charts::{RGBColor, color};
pub(super) use world::Hierarchy;
use world::World;

const NAME: &str = NAMES[0];
const COLOR: RGBColor = color::GREEN;

fn introduce(broad_phase: &mut DefaultBroadPhase, world: &mut World) {
    update(broad_phase, world);
}

fn update(broad_phase: &mut DefaultBroadPhase, world: &mut World) {
    BroadPhase::update(
        broad_phase,
        &world.params,
        &world.colliders,
        &world.bodies,
        &world.listed,
        &[],
        &mut world.events,
    );
}
