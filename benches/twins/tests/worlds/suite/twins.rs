//! Two equal worlds, one with our broad phase and one with Rapier's.

use std::fmt::Debug;

use super::rapier::parry::query::DefaultQueryDispatcher;
use super::rapier::prelude::*;
use super::scenes::{self, AngVector, Vector, vector};
use super::snapshot::{EventLog, Snapshot};
use super::version;
use super::{Installed, PairFilter, Settings, Steppable, UnisizeBroadPhase, World, install};

pub(crate) struct Twins {
    pub(crate) ours: World,
    pub(crate) theirs: World,
    pub(crate) unisize: Installed<UnisizeBroadPhase>,
    pub(crate) default: DefaultBroadPhase,
}

impl Twins {
    pub(crate) fn heavy() -> Self {
        Self::with(Settings::default())
    }

    pub(crate) fn weightless() -> Self {
        Self::heavy().without_gravity()
    }

    pub(crate) fn with(settings: Settings) -> Self {
        Self {
            ours: World::new(at(0.0, -9.81)),
            theirs: World::new(at(0.0, -9.81)),
            unisize: install(UnisizeBroadPhase::with_settings(settings)),
            default: DefaultBroadPhase::new(),
        }
    }

    pub(crate) fn with_filter(filter: PairFilter) -> Self {
        Self::with(Settings::default().with_filter(filter))
    }

    pub(crate) fn without_gravity(mut self) -> Self {
        self.both(|world| world.gravity = Vector::default());
        self
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

    /// Inserts another collider on a body.
    pub(crate) fn insert_part(
        &mut self,
        body: RigidBodyHandle,
        collider: ColliderBuilder,
    ) -> ColliderHandle {
        let collider = collider.active_events(ActiveEvents::all());
        self.both(|world| {
            let bodies = &mut world.bodies;
            world
                .colliders
                .insert_with_parent(collider.clone(), body, bodies)
        })
    }

    /// Inserts a wide fixed floor with its top at height 0.
    pub(crate) fn insert_floor(&mut self) -> (RigidBodyHandle, ColliderHandle) {
        let floor = cuboid([100.0, 1.0, 100.0]).translation(at(0.0, -1.0));
        self.insert(RigidBodyBuilder::fixed(), floor)
    }

    /// Removes a body with its colliders.
    pub(crate) fn remove(&mut self, body: RigidBodyHandle) {
        self.both(|world| world.remove(body));
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
            let bodies = &mut world.bodies;
            world.colliders.set_parent(collider, body, bodies);
        });
    }

    /// The answers of both worlds, ours first.
    pub(crate) fn answers<T>(&mut self, ask: impl Fn(&World, QueryPipeline<'_>) -> T) -> [T; 2] {
        self.answers_with(QueryFilter::default(), ask)
    }

    /// The answers of both worlds to what is asked with a filter, ours first.
    pub(crate) fn answers_with<T>(
        &mut self,
        filter: QueryFilter<'_>,
        ask: impl Fn(&World, QueryPipeline<'_>) -> T,
    ) -> [T; 2] {
        let (dispatcher, ours, theirs) = (&DefaultQueryDispatcher, &self.ours, &self.theirs);
        let (bodies, colliders) = (&ours.bodies, &ours.colliders);
        let asked = version::asked(&mut self.unisize);
        let answer = ask(
            ours,
            asked.as_query_pipeline(dispatcher, bodies, colliders, filter),
        );
        let (asked, bodies, colliders) = (&self.default, &theirs.bodies, &theirs.colliders);
        let scene = asked.as_query_pipeline(dispatcher, bodies, colliders, filter);
        [answer, ask(theirs, scene)]
    }

    /// Asks both worlds the same; the answers must be equal.
    #[track_caller]
    pub(crate) fn same<T: PartialEq + Debug>(&mut self, ask: impl Fn(QueryPipeline<'_>) -> T) -> T {
        let [ours, theirs] = self.answers(|_, scene| ask(scene));
        assert_eq!(ours, theirs);
        ours
    }

    /// Asks both worlds the same, ours first, and changes them alike; the results must be equal, to the last bit.
    pub(crate) fn both_scenes<T: Debug>(
        &mut self,
        filter: QueryFilter<'_>,
        mut ask: impl FnMut(QueryPipelineMut<'_>) -> T,
    ) -> T {
        let dispatcher = &DefaultQueryDispatcher;
        let (bodies, colliders) = (&mut self.ours.bodies, &mut self.ours.colliders);
        let scene = version::asked(&mut self.unisize);
        let answer = ask(scene.as_query_pipeline_mut(dispatcher, bodies, colliders, filter));
        let (bodies, colliders) = (&mut self.theirs.bodies, &mut self.theirs.colliders);
        let scene = &self.default;
        let expected = ask(scene.as_query_pipeline_mut(dispatcher, bodies, colliders, filter));
        // Numbers are printed so that they read back the same.
        assert_eq!(format!("{answer:?}"), format!("{expected:?}"));
        answer
    }

    /// Makes one step; both worlds must look the same.
    pub(crate) fn step(&mut self) -> Snapshot {
        let logs = [EventLog::default(), EventLog::default()];
        self.ours.step(self.unisize.for_step(), &(), &logs[0]);
        self.theirs.step(self.default.for_step(), &(), &logs[1]);
        self.compare(logs)
    }

    /// One step of a collision pipeline, without dynamics.
    pub(crate) fn collide(&mut self) -> Snapshot {
        let logs = [EventLog::default(), EventLog::default()];
        self.ours.collide(self.unisize.for_step(), &logs[0]);
        self.theirs.collide(self.default.for_step(), &logs[1]);
        self.compare(logs)
    }

    fn compare(&self, logs: [EventLog; 2]) -> Snapshot {
        self.unisize.validate();
        let [ours, theirs] = self.snapshots(logs);
        assert_alike(&ours, &theirs);
        ours
    }

    /// What is seen of both worlds after a step, ours first.
    pub(crate) fn snapshots(&self, [our_log, their_log]: [EventLog; 2]) -> [Snapshot; 2] {
        let ours = Snapshot::of(&self.ours, our_log);
        [ours, Snapshot::of(&self.theirs, their_log)]
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

/// Panics unless both worlds look the same.
#[track_caller]
pub(crate) fn assert_alike(ours: &Snapshot, theirs: &Snapshot) {
    if ours != theirs {
        // Not-a-number is not equal to itself, but looks the same.
        let [ours, theirs] = [ours, theirs].map(|seen| format!("{seen:#?}"));
        assert_eq!(ours, theirs, "with ours (left) and with Rapier's (right)");
    }
}

/// The vector with these components. A world of two dimensions ignores the last one.
pub(crate) fn triple(xyz: [Real; 3]) -> Vector {
    vector(|axis| xyz[axis])
}

/// A spin of this many radians per second about the third axis, and in 3D also about the others.
pub(crate) fn spin(speed: Real) -> AngVector {
    scenes::spin([0.3 * speed, 0.1 * speed, speed])
}

/// The point or direction in the plane of the first two axes.
pub(crate) fn at(x: Real, y: Real) -> Vector {
    triple([x, y, 0.0])
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
