//! The result of building a scene: a world, its script, and the containers and joints by which its sanity is measured.

use super::container::Container;
use super::flavour;
use super::observed::Observed;
use super::rapier::prelude::*;
use super::script::{Cue, Script};
use super::space::{GRAVITY, Point, UP, Vector, along, cuboid, wide_high};
use super::version::{OwnBroadPhase, install};
use super::world::{Steppable, World};

/// A joint of a rope.
#[derive(Clone)]
pub(super) struct Link {
    /// The joint.
    pub(super) joint: ImpulseJointHandle,
    /// The bodies that it joins.
    pub(super) bodies: [RigidBodyHandle; 2],
    /// The length of a segment of its rope.
    pub(super) length: Real,
}

/// A world before its first step, with its script and the parts that sanity is measured by.
pub(super) struct Stage {
    /// The world.
    pub(super) world: World,
    /// The script that drives it.
    pub(super) script: Box<dyn Script>,
    /// The boxes that bodies should not leave. The user data of a body is the index of its container.
    pub(super) containers: Vec<Container>,
    /// The joints whose stretch is measured.
    pub(super) links: Vec<Link>,
    /// The number of bodies that may leave their container without a complaint.
    pub(super) may_fall_through: usize,
}

impl Stage {
    /// A world without a script, in one container.
    pub(super) fn new(world: World, container: Container) -> Self {
        Self {
            world,
            script: Box::new(|_: &mut World, _: &mut Cue| {}),
            containers: vec![container],
            links: Vec::new(),
            may_fall_through: 0,
        }
    }

    /// A world with gravity, in a room with a floor and walls, which bodies may leave through its top.
    pub(super) fn walled(walls: Container) -> Self {
        let mut stage = Self::new(falling(), walls.open());
        walls.wall_in(&mut stage.world, false, |side| side.build());
        stage
    }

    /// A world with gravity, and with a floor whose top is at height zero.
    pub(super) fn on_floor(half_width: Real) -> Self {
        const HALF_THICKNESS: Real = 2.0;
        let mut stage = Self::new(falling(), Container::above_ground());
        let floor = cuboid(wide_high(half_width, HALF_THICKNESS));
        let colliders = &mut stage.world.colliders;
        colliders.insert(floor.translation(along(UP, -HALF_THICKNESS)));
        stage
    }

    /// Inserts a body that is free to move.
    pub(super) fn insert(
        &mut self,
        center: Vector,
        collider: impl Into<Collider>,
    ) -> RigidBodyHandle {
        let body = RigidBodyBuilder::dynamic().translation(center);
        self.world.insert(body, collider)
    }

    /// Pins a point of one body to a point of another, as in a rope with segments of this length.
    pub(super) fn pin(&mut self, ends: [(RigidBodyHandle, Vector); 2], length: Real) {
        let [(first, first_point), (second, second_point)] = ends;
        let pin = GenericJointBuilder::new(flavour::PIN)
            .local_anchor1(Point::from(first_point))
            .local_anchor2(Point::from(second_point))
            .contacts_enabled(false);
        let joints = &mut self.world.impulse_joints;
        self.links.push(Link {
            joint: joints.insert(first, second, pin, true),
            bodies: [first, second],
            length,
        });
    }

    /// Steps the world until its bodies have come to rest, and returns a world that starts with them there, awake.
    ///
    /// No broad phase knows it yet. Its bodies have a collider each, and neither joints nor a script.
    pub(super) fn settled(mut self) -> Self {
        // A new world has no contact forces of the step before, so that bodies that only just stood come down. The last world has
        // none of these.
        for _ in 0..WORLDS_TO_SETTLE {
            let mut broad_phase = install(Observed::new(OwnBroadPhase::new()).sorted());
            for _ in 0..STEPS_TO_SETTLE {
                self.world.step(broad_phase.for_step(), &(), &());
            }
            self.world = at_rest(&self.world);
        }
        self
    }

    /// Returns the stage with a script.
    pub(super) fn with_script(mut self, script: impl Script + 'static) -> Self {
        self.script = Box::new(script);
        self
    }
}

/// The number of worlds that bodies come to rest in, one after the other, and of steps in each.
const WORLDS_TO_SETTLE: usize = 4;
const STEPS_TO_SETTLE: usize = 200;

/// A new world with the bodies where they are, at rest and awake.
fn at_rest(world: &World) -> World {
    let mut new = World::new(world.gravity);
    for (_, collider) in world.colliders.iter() {
        let Some(parent) = collider.parent() else {
            new.colliders.insert(collider.clone());
            continue;
        };
        let mut body = RigidBodyBuilder::dynamic().build();
        body.set_position(*world.bodies[parent].position(), true);
        new.insert(body, collider.clone());
    }
    new
}

/// A world with gravity.
pub(super) fn falling() -> World {
    World::new(along(UP, -GRAVITY))
}
