//! One world that both broad phases watch, so that what they are asked is about the very same colliders.

use std::collections::BTreeSet;

use super::rapier::parry::partitioning::{Bvh, TraversalAction};
use super::rapier::parry::query::DefaultQueryDispatcher;
use super::rapier::prelude::*;
use super::{Settings, Tee, UnisizeBroadPhase, World, mesh_floor, spin};
use crate::questions::{Body, Change, Filter, NewCollider, Pick, Pose, Shape, Triple};

/// A world in which nothing collides, so that it stays as it was made: bodies fly through each other.
pub(super) struct Watched {
    pub(super) world: World,
    /// Rapier gets the events of its own.
    pub(super) watchers: Tee<DefaultBroadPhase, UnisizeBroadPhase>,
    /// The colliders, in the order in which they were inserted.
    handles: Vec<ColliderHandle>,
}

impl Watched {
    pub(super) fn new(margin: f32) -> Self {
        let settings = Settings::default().with_margin(Real::from(margin));
        // These are never removed. Rapier's tree loops forever, or panics, once it has lost all but one of its colliders.
        let mut world = World::new(Vector::zeros());
        for x in [-20.0, 0.0, 20.0] {
            let collider = ColliderBuilder::ball(0.5).translation(vector([x, 15.0, 0.0]));
            world.colliders.insert(collider);
        }
        Self {
            world,
            watchers: Tee::new(
                DefaultBroadPhase::new(),
                UnisizeBroadPhase::with_settings(settings),
            ),
            handles: Vec::new(),
        }
    }

    pub(super) fn step(&mut self) {
        self.world.step(&mut self.watchers, &(), &());
        self.watchers.unheard.validate();
    }

    pub(super) fn change(&mut self, change: Change) {
        let pick = match change {
            Change::Insert(new) => return self.insert(new),
            Change::Remove(pick)
            | Change::Enable(pick, _)
            | Change::Place(pick, _)
            | Change::Resize(pick, _)
            | Change::Sensor(pick, _) => pick,
        };
        let Some(handle) = self.nth(pick) else {
            return;
        };
        let World {
            islands,
            bodies,
            colliders,
            ..
        } = &mut self.world;
        let collider = &mut colliders[handle];
        match change {
            Change::Insert(_) => {}
            Change::Remove(_) => {
                colliders.remove(handle, islands, bodies, true);
                self.handles.retain(|&other| other != handle);
            }
            Change::Enable(_, on) => collider.set_enabled(on),
            Change::Place(_, pose) => match collider.parent() {
                Some(body) => bodies[body].set_position(isometry(pose), true),
                None => collider.set_position(isometry(pose)),
            },
            Change::Resize(_, shape) => collider.set_shape(builder(shape).shape),
            Change::Sensor(_, on) => collider.set_sensor(on),
        }
    }

    fn insert(&mut self, new: NewCollider) {
        let groups = Group::from_bits_truncate(new.groups);
        let collider = builder(new.shape)
            .sensor(new.sensor)
            .enabled(new.enabled)
            .collision_groups(InteractionGroups::new(groups, Group::all()))
            .active_collision_types(ActiveCollisionTypes::empty());
        let World {
            bodies, colliders, ..
        } = &mut self.world;
        let handle = match new.body {
            None => colliders.insert(collider.position(isometry(new.pose))),
            Some(body) => {
                let body = match body {
                    Body::Dynamic => RigidBodyBuilder::dynamic(),
                    Body::Fixed => RigidBodyBuilder::fixed(),
                    Body::Kinematic => RigidBodyBuilder::kinematic_velocity_based(),
                };
                let body = body.position(isometry(new.pose));
                let body = body.linvel(vector(new.velocity));
                colliders.insert_with_parent(collider, bodies.insert(body), bodies)
            }
        };
        self.handles.push(handle);
    }

    fn nth(&self, pick: Pick) -> Option<ColliderHandle> {
        self.handles.get(pick % self.handles.len().max(1)).copied()
    }

    pub(super) fn has_any(&self, filter: QueryFilter<'_>) -> bool {
        let World {
            bodies, colliders, ..
        } = &self.world;
        let mut enabled = colliders.iter_enabled();
        enabled.any(|(handle, collider)| filter.test(bodies, handle, collider))
    }

    /// Checks that both trees have all colliders that are enabled.
    pub(super) fn check_trees(&self) {
        let colliders = &self.world.colliders;
        let enabled = colliders.iter_enabled();
        let enabled: BTreeSet<u32> = enabled
            .map(|(handle, _)| handle.into_raw_parts().0)
            .collect();
        let (dispatcher, filter) = (&DefaultQueryDispatcher, QueryFilter::default());
        let bodies = &self.world.bodies;
        let (default, unisize) = (&self.watchers.heard, &self.watchers.unheard);
        let ours = unisize.as_query_pipeline(dispatcher, bodies, colliders, filter);
        assert_eq!(leaves(ours.bvh, enabled.len()).as_ref(), Some(&enabled));
        let theirs = default.as_query_pipeline(dispatcher, bodies, colliders, filter);
        assert_eq!(leaves(theirs.bvh, enabled.len()), Some(enabled));
    }

    /// Rapier's filter; the caller adds the predicate.
    pub(super) fn filter(&self, filter: Filter) -> QueryFilter<'static> {
        let body_of = filter.body_of.and_then(|pick| self.nth(pick));
        let groups = filter.groups.map(Group::from_bits_truncate);
        QueryFilter {
            flags: QueryFilterFlags::from_bits_truncate(filter.flags),
            groups: groups.map(|groups| InteractionGroups::new(groups, groups)),
            exclude_collider: filter.collider.and_then(|pick| self.nth(pick)),
            exclude_rigid_body: body_of.and_then(|handle| self.world.colliders[handle].parent()),
            predicate: None,
        }
    }
}

/// The leaves of a tree, by index, or `None` if it has a cycle.
fn leaves(tree: &Bvh, most: usize) -> Option<BTreeSet<u32>> {
    let (mut leaves, mut nodes) = (BTreeSet::new(), 0);
    tree.traverse(|node| {
        leaves.extend(node.leaf_data());
        nodes += 1;
        match nodes > 2 * most {
            true => TraversalAction::EarlyExit,
            false => TraversalAction::Continue,
        }
    });
    (nodes <= 2 * most).then_some(leaves)
}

/// A collider of this shape.
pub(super) fn builder(shape: Shape) -> ColliderBuilder {
    match shape {
        Shape::Ball(radius) => ColliderBuilder::ball(radius.into()),
        Shape::Cuboid(half) => ColliderBuilder::new(SharedShape::new(Cuboid::new(vector(half)))),
        Shape::Capsule(half, radius) => ColliderBuilder::capsule_y(half.into(), radius.into()),
        Shape::Compound(radius, gap) => {
            let ball = SharedShape::ball(radius.into());
            let apart = Isometry::from_parts(vector([gap; 3]).into(), Rotation::identity());
            ColliderBuilder::compound(vec![(Isometry::identity(), ball.clone()), (apart, ball)])
        }
        Shape::Mesh(half) => mesh_floor(half.into()),
    }
}

pub(super) fn isometry(pose: Pose) -> Isometry<Real> {
    Isometry::new(vector(pose.at), spin(pose.turn.into()))
}

pub(super) fn vector(triple: Triple) -> Vector<Real> {
    Vector::from_fn(|i, _| Real::from(triple[i]))
}
