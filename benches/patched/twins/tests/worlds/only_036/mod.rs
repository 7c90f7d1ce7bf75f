//! What is tested with Rapier 0.36 alone: its `PhysicsWorld` and soft bodies, what a user changes, exchanged broad phases and
//! recycled contacts.

use super::rapier;
use super::scenes;
use super::suite::{ordered, random, snapshot, twins};
use super::version;
use super::{PairFilter, Settings, Steppable, Trial, UnisizeBroadPhase, World, install};

mod changes;
mod exchange;
mod near_misses;
mod observing;
mod physics_world;
mod reach;
mod recycling;
mod soft_bodies;
mod stretched;
mod unbounded;
