//! What is tested with Rapier 0.36 alone: its `PhysicsWorld`, boxes that are handed over, recycled contacts and soft bodies.

use super::dim::soft_body;
use super::rapier;
use super::suite::{random, snapshot, twins};
use super::{
    PairFilter, Settings, Steppable, Trial, UnisizeBroadPhase, World, height_field, install,
    mesh_floor,
};

mod changes;
mod exchange;
mod looking_on;
mod misuse;
mod physics_world;
mod recycling;
mod soft_bodies;
