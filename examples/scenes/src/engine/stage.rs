//! The result of building a scene: a world, its script, and what its sanity is measured by.

use super::container::Container;
use super::rapier::prelude::*;
use super::script::{Nothing, Script};
use super::world::World;

/// A joint of a rope.
pub(super) struct Link {
    /// The joint.
    pub(super) joint: ImpulseJointHandle,
    /// What it joins.
    pub(super) bodies: [RigidBodyHandle; 2],
    /// The length of a segment of its rope.
    pub(super) length: Real,
}

/// A world as it is before the first step, with what is needed to go on.
pub(super) struct Stage {
    /// The world.
    pub(super) world: World,
    /// What drives it.
    pub(super) script: Box<dyn Script>,
    /// Where bodies are meant to stay. The user data of a body is the index of its container.
    pub(super) containers: Vec<Container>,
    /// The joints whose stretch is measured.
    pub(super) links: Vec<Link>,
    /// How many bodies may leave their container without anything being wrong.
    pub(super) may_fall_through: usize,
}

impl Stage {
    /// A world that is left to itself, in one container.
    pub(super) fn new(world: World, container: Container) -> Self {
        Self {
            world,
            script: Box::new(Nothing),
            containers: vec![container],
            links: Vec::new(),
            may_fall_through: 0,
        }
    }

    /// The same stage with a script.
    pub(super) fn with_script(mut self, script: impl Script + 'static) -> Self {
        self.script = Box::new(script);
        self
    }
}
