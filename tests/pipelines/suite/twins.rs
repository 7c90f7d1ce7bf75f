//! Two equal worlds, one with our broad phase and one with Rapier's.

use std::fmt::Debug;

use super::rapier::parry::query::DefaultQueryDispatcher;
use super::rapier::prelude::*;
use super::snapshot::{EventLog, Snapshot};
use super::{UnisizeBroadPhase, World};

pub(crate) struct Twins {
    pub(crate) ours: World,
    pub(crate) theirs: World,
    pub(crate) unisize: UnisizeBroadPhase,
    pub(crate) default: DefaultBroadPhase,
    /// The hooks of both.
    pub(crate) hooks: Box<dyn PhysicsHooks>,
}

impl Twins {
    /// Without gravity.
    pub(crate) fn weightless() -> Self {
        Self::with_gravity(Vector::zeros())
    }

    pub(crate) fn heavy() -> Self {
        Self::with_gravity(at(0.0, -9.81))
    }

    fn with_gravity(gravity: Vector<Real>) -> Self {
        Self {
            ours: World::new(gravity),
            theirs: World::new(gravity),
            unisize: UnisizeBroadPhase::new(),
            default: DefaultBroadPhase::new(),
            hooks: Box::new(()),
        }
    }

    /// Does the same to both worlds; the results must be equal.
    pub(crate) fn both<T: PartialEq + Debug>(&mut self, change: impl Fn(&mut World) -> T) -> T {
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
        self.both(|world| {
            let body = world.insert(body.clone(), collider.clone());
            (body, world.bodies[body].colliders()[0])
        })
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

    /// Asks both worlds the same, ours first, and changes them alike; the results must be equal, to the last bit.
    pub(crate) fn both_scenes<T: Debug>(
        &mut self,
        filter: QueryFilter<'_>,
        mut ask: impl FnMut(QueryPipelineMut<'_>) -> T,
    ) -> T {
        let dispatcher = &DefaultQueryDispatcher;
        let Self { ours, theirs, .. } = self;
        let World {
            bodies, colliders, ..
        } = ours;
        let scene = &self.unisize;
        let answer = ask(scene.as_query_pipeline_mut(dispatcher, bodies, colliders, filter));
        let World {
            bodies, colliders, ..
        } = theirs;
        let scene = &self.default;
        let expected = ask(scene.as_query_pipeline_mut(dispatcher, bodies, colliders, filter));
        // Numbers are printed so that they read back the same.
        assert_eq!(format!("{answer:?}"), format!("{expected:?}"));
        answer
    }

    /// Makes one step; both worlds must look the same.
    pub(crate) fn step(&mut self) -> Snapshot {
        let (our_log, their_log) = (EventLog::default(), EventLog::default());
        let hooks = &*self.hooks;
        self.ours.step(&mut self.unisize, hooks, &our_log);
        self.theirs.step(&mut self.default, hooks, &their_log);
        self.compare(our_log, their_log)
    }

    /// One step of a collision pipeline, without dynamics.
    pub(crate) fn collide(&mut self) -> Snapshot {
        let (our_log, their_log) = (EventLog::default(), EventLog::default());
        let hooks = &*self.hooks;
        collide(&mut self.ours, &mut self.unisize, hooks, &our_log);
        collide(&mut self.theirs, &mut self.default, hooks, &their_log);
        self.compare(our_log, their_log)
    }

    fn compare(&self, our_log: EventLog, their_log: EventLog) -> Snapshot {
        self.unisize.validate();
        let ours = Snapshot::of(&self.ours, our_log);
        let theirs = Snapshot::of(&self.theirs, their_log);
        assert_eq!(ours, theirs, "with ours (left) and with Rapier's (right)");
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

fn collide(
    world: &mut World,
    broad_phase: &mut dyn BroadPhase,
    hooks: &dyn PhysicsHooks,
    events: &dyn EventHandler,
) {
    CollisionPipeline::new().step(
        0.002,
        broad_phase,
        &mut world.narrow_phase,
        &mut world.bodies,
        &mut world.colliders,
        hooks,
        events,
    );
}

/// The point or direction in the plane of the first two axes.
pub(crate) fn at(x: Real, y: Real) -> Vector<Real> {
    triple([x, y, 0.0])
}

/// The last coordinate is unused in two dimensions.
pub(crate) fn triple(xyz: [Real; 3]) -> Vector<Real> {
    Vector::from_fn(|i, _| xyz[i])
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
