//! Two equal worlds, one with our broad phase and one with Rapier's.

use std::fmt::Debug;

use super::UnisizeBroadPhase;
use super::rapier::prelude::*;
use super::snapshot::{EventLog, Snapshot};

pub(crate) struct Twins {
    pub(crate) ours: PhysicsWorld,
    pub(crate) theirs: PhysicsWorld,
    /// The hooks of both.
    pub(crate) hooks: Box<dyn PhysicsHooks>,
}

/// A world with our broad phase.
pub(crate) fn world_with(broad_phase: UnisizeBroadPhase) -> PhysicsWorld {
    PhysicsWorld {
        broad_phase: DefaultBroadPhase::custom(broad_phase),
        ..PhysicsWorld::default()
    }
}

/// Our broad phase in a world.
pub(crate) fn unisize(world: &PhysicsWorld) -> &UnisizeBroadPhase {
    let custom = world.broad_phase.custom_ref();
    custom.expect("the world was made with it")
}

impl Twins {
    pub(crate) fn heavy() -> Self {
        Self::with(UnisizeBroadPhase::new())
    }

    pub(crate) fn weightless() -> Self {
        Self::heavy().without_gravity()
    }

    pub(crate) fn with(broad_phase: UnisizeBroadPhase) -> Self {
        Self {
            ours: world_with(broad_phase),
            theirs: PhysicsWorld::default(),
            hooks: Box::new(()),
        }
    }

    pub(crate) fn without_gravity(mut self) -> Self {
        self.both(|world| world.gravity = Vector::ZERO);
        self
    }

    /// Does the same to both worlds; the results must be equal.
    pub(crate) fn both<T: PartialEq + Debug>(
        &mut self,
        change: impl Fn(&mut PhysicsWorld) -> T,
    ) -> T {
        let result = change(&mut self.ours);
        assert_eq!(result, change(&mut self.theirs));
        result
    }

    /// Inserts a body with one collider that reports its collisions.
    pub(crate) fn insert(
        &mut self,
        body: RigidBodyBuilder,
        collider: ColliderBuilder,
    ) -> (RigidBodyHandle, ColliderHandle) {
        let collider = collider.active_events(ActiveEvents::all());
        self.both(|world| world.insert(body.clone(), collider.clone()))
    }

    /// Inserts another collider on a body.
    pub(crate) fn insert_part(
        &mut self,
        body: RigidBodyHandle,
        collider: ColliderBuilder,
    ) -> ColliderHandle {
        let collider = collider.active_events(ActiveEvents::all());
        self.both(|world| world.insert_collider(collider.clone(), Some(body)))
    }

    /// Inserts a wide fixed floor with its top at height 0.
    pub(crate) fn insert_floor(&mut self) -> (RigidBodyHandle, ColliderHandle) {
        let floor = cuboid([100.0, 1.0, 100.0]).translation(at(0.0, -1.0));
        self.insert(RigidBodyBuilder::fixed(), floor)
    }

    /// Changes a collider in both worlds.
    pub(crate) fn change(&mut self, collider: ColliderHandle, change: impl Fn(&mut Collider)) {
        self.both(|world| change(&mut world.colliders[collider]));
    }

    /// Changes a body in both worlds.
    pub(crate) fn change_body(&mut self, body: RigidBodyHandle, change: impl Fn(&mut RigidBody)) {
        self.both(|world| change(&mut world.bodies[body]));
    }

    /// Gives a collider another body, or none.
    pub(crate) fn set_parent(&mut self, collider: ColliderHandle, body: Option<RigidBodyHandle>) {
        self.both(|world| {
            world
                .colliders
                .set_parent(collider, body, &mut world.bodies)
        });
    }

    /// Asks both worlds the same, ours first, and changes them alike; the results must be equal, to the last bit.
    pub(crate) fn both_scenes<T: Debug>(
        &mut self,
        filter: QueryFilter<'_>,
        mut ask: impl FnMut(QueryPipelineMut<'_>) -> T,
    ) -> T {
        let [answer, expected] = [&mut self.ours, &mut self.theirs].map(|world| {
            ask(world.broad_phase.as_query_pipeline_mut(
                world.narrow_phase.query_dispatcher(),
                &mut world.bodies,
                &mut world.colliders,
                filter,
            ))
        });
        // Numbers are printed so that they read back the same.
        assert_eq!(format!("{answer:?}"), format!("{expected:?}"));
        answer
    }

    /// Makes one step; both worlds must look the same.
    pub(crate) fn step(&mut self) -> Snapshot {
        self.compare(PhysicsWorld::step_with_events)
    }

    /// One step of a collision pipeline, without dynamics.
    pub(crate) fn collide(&mut self) -> Snapshot {
        self.compare(PhysicsWorld::detect_collisions)
    }

    fn compare(
        &mut self,
        step: impl Fn(&mut PhysicsWorld, &dyn PhysicsHooks, &dyn EventHandler),
    ) -> Snapshot {
        let [ours, theirs] = [&mut self.ours, &mut self.theirs].map(|world| {
            let log = EventLog::default();
            step(world, &*self.hooks, &log);
            Snapshot::of(world, log)
        });
        unisize(&self.ours).validate();
        if ours != theirs {
            // Not-a-number is not equal to itself, but looks the same.
            let [ours, theirs] = [&ours, &theirs].map(|seen| format!("{seen:#?}"));
            assert_eq!(ours, theirs, "with ours (left) and with Rapier's (right)");
        }
        ours
    }

    /// Makes this many steps, and returns what is seen after the last.
    pub(crate) fn steps(&mut self, count: usize) -> Snapshot {
        for _ in 1..count {
            self.step();
        }
        self.step()
    }

    /// Steps until something is seen, and returns that step.
    pub(crate) fn step_until(&mut self, seen: impl Fn(&Snapshot) -> bool) -> Snapshot {
        for _ in 0..600 {
            let snapshot = self.step();
            if seen(&snapshot) {
                return snapshot;
            }
        }
        panic!("it did not happen within 600 steps");
    }
}

/// The point or direction in the plane of the first two axes.
pub(crate) fn at(x: Real, y: Real) -> Vector {
    triple([x, y, 0.0])
}

/// The last coordinate is unused in two dimensions.
pub(crate) fn triple(xyz: [Real; 3]) -> Vector {
    Vector::from(std::array::from_fn(|i| xyz[i]))
}

pub(crate) fn cuboid(half: [Real; 3]) -> ColliderBuilder {
    ColliderBuilder::new(SharedShape::new(Cuboid::new(triple(half))))
}

/// A cube of side 1.
pub(crate) fn cube() -> ColliderBuilder {
    cuboid([0.5; 3])
}

pub(crate) fn dynamic(x: Real, y: Real) -> RigidBodyBuilder {
    RigidBodyBuilder::dynamic().translation(at(x, y))
}

pub(crate) fn fixed(x: Real, y: Real) -> RigidBodyBuilder {
    RigidBodyBuilder::fixed().translation(at(x, y))
}
