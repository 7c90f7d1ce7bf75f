//! The scenes, each in its own file: from a number of bodies and a generator to a stage.

use super::container::Container;
use super::lattice::Lattice;
use super::rapier::{math::DIM, prelude::*};
use super::script::{Cue, Script};
use super::space::*;
use super::space::{Point, Vector};
use super::stage::{Stage, falling};
use super::world::World;
use super::{flavour, rapier, vehicle, version};
use crate::SceneKind;
use crate::random::Random;

mod bullets;
mod churn;
mod crowd;
mod gas;
mod grains;
mod habits;
mod hopper;
mod masonry;
mod mixed;
mod net;
mod player;
mod ropes;
mod shapes;
mod ships;
mod sleeping;
mod soft;
mod swarm;
mod tile_map;

/// Builds the stage of a scene.
pub(super) fn build(kind: SceneKind, bodies: usize, random: &mut Random) -> Stage {
    match kind {
        SceneKind::FallingBalls => grains::build(bodies, random),
        SceneKind::Pyramid => masonry::build_pyramid(bodies, random),
        SceneKind::Gas => gas::build(bodies, random),
        SceneKind::Ropes => ropes::build_ropes(bodies, random),
        SceneKind::Net => net::build(bodies, random),
        SceneKind::Hopper => hopper::build(bodies, random),
        SceneKind::Crowd => crowd::build(bodies, random),
        SceneKind::Swarm => swarm::build(bodies, random),
        SceneKind::Sleeping => sleeping::build(bodies, random),
        SceneKind::MixedOneAndAHalf => mixed::build_heap(bodies, 1.5, random),
        SceneKind::MixedFour => mixed::build_heap(bodies, 4.0, random),
        SceneKind::MixedEight => mixed::build_heap(bodies, 8.0, random),
        SceneKind::MixedThousand => mixed::build_hills(bodies, random),
        SceneKind::Bullets => bullets::build(bodies, random),
        SceneKind::Churn => churn::build(bodies, random),
        SceneKind::Shapes => shapes::build(bodies, random),
        SceneKind::Soft => soft::build(bodies, random),
        SceneKind::TileMap => tile_map::build(bodies, random),
        SceneKind::Ships => ships::build(bodies, random),
        SceneKind::OneBody => ships::build_one(bodies, random),
        SceneKind::Ghosts => gas::build_ghosts(bodies, random),
        SceneKind::Player => player::build(bodies, random),
        SceneKind::Columns => masonry::build_towers(bodies, masonry::COLUMNS, random),
        SceneKind::Stacks => masonry::build_towers(bodies, masonry::STACKS, random),
        SceneKind::Wall => masonry::build_wall(bodies, random),
        SceneKind::Pyramids => masonry::build_pyramids(bodies, random),
        SceneKind::Chains => ropes::build_chains(bodies, random),
        SceneKind::Touched => habits::build_touched(bodies, random),
        SceneKind::Restated => habits::build_restated(bodies, random),
        SceneKind::Breathing => habits::build_breathing(bodies, random),
        SceneKind::SettledPile => grains::build(bodies, random).settled(),
        SceneKind::SettledHeap => masonry::build_heap(bodies, random).settled(),
    }
}

/// A world without gravity.
fn floating() -> World {
    World::new(vector(|_| 0.0))
}

/// Inserts fixed balls above the floor, so far apart, which ropes and nets come to lie over.
fn insert_obstacles(world: &mut World, half_width: Real, apart: Real, random: &mut Random) {
    const RADIUS: Real = 0.6;
    let columns = ((2.0 * half_width / apart) as usize).max(1);
    let lattice = Lattice::with_columns(columns.pow(DIM as u32 - 1), apart, columns);
    for index in 0..lattice.per_layer() {
        let center = lattice.center(index) + jitter(random, 0.5);
        let ball = ColliderBuilder::ball(RADIUS);
        world.colliders.insert(ball.translation(center));
    }
}
