//! The broad phase of Rapier 0.36 in the place of one of Rapier 0.27.
//!
//! Its pipeline takes no other broad phase, but the broad phase can be driven by hand: it is given the boxes that 0.27 computes,
//! loosened as in its own pipeline. It asks the colliders of a world of its version only for what decides whom they may meet, so
//! that world has twins with the types of bodies and the groups, and with no shape worth mentioning.

use super::newest::prelude as newer;
use super::scenes::rapier::{math::DIM, prelude::*};
use std::collections::HashMap;

/// The broad phase of Rapier 0.36, with the world that it looks at.
#[derive(Default)]
pub(super) struct Rapier036 {
    tree: newer::BroadPhaseBvh,
    params: newer::IntegrationParameters,
    bodies: newer::RigidBodySet,
    colliders: newer::ColliderSet,
    /// By the index of the original's handle.
    twins: Vec<Option<newer::ColliderHandle>>,
    /// By the index of the twin's handle.
    originals: Vec<ColliderHandle>,
    parents: HashMap<RigidBodyHandle, newer::RigidBodyHandle>,
    events: Vec<newer::BroadPhasePairEvent>,
}

impl Rapier036 {
    /// The twin of a collider, which is made if there is none.
    fn twin(
        &mut self,
        handle: ColliderHandle,
        collider: &Collider,
        bodies: &RigidBodySet,
    ) -> newer::ColliderHandle {
        let slot = handle.into_raw_parts().0 as usize;
        if self.twins.len() <= slot {
            self.twins.resize(slot + 1, None);
        }
        if let Some(twin) = self.twins[slot] {
            return twin;
        }
        let twin = builder(collider);
        let twin = match collider.parent() {
            None => self.colliders.insert(twin),
            Some(parent) => {
                let twins = &mut self.bodies;
                let kind = body_type(bodies[parent].body_type());
                let new = || twins.insert(newer::RigidBodyBuilder::new(kind));
                let body = *self.parents.entry(parent).or_insert_with(new);
                self.colliders
                    .insert_with_parent(twin, body, &mut self.bodies)
            }
        };
        let index = twin.into_raw_parts().0 as usize;
        if self.originals.len() <= index {
            self.originals.resize(index + 1, ColliderHandle::invalid());
        }
        self.originals[index] = handle;
        self.twins[slot] = Some(twin);
        twin
    }

    fn original(&self, pair: newer::ColliderPair) -> ColliderPair {
        let original =
            |twin: newer::ColliderHandle| self.originals[twin.into_raw_parts().0 as usize];
        ColliderPair::new(original(pair.collider1), original(pair.collider2))
    }
}

/// What decides whom a collider may meet.
fn builder(collider: &Collider) -> newer::ColliderBuilder {
    let groups = collider.collision_groups();
    let group = |group: Group| newer::Group::from_bits_retain(group.bits());
    let types = collider.active_collision_types().bits();
    newer::ColliderBuilder::ball(1.0)
        .sensor(collider.is_sensor())
        .collision_groups(newer::InteractionGroups {
            memberships: group(groups.memberships),
            filter: group(groups.filter),
            ..newer::InteractionGroups::all()
        })
        .active_collision_types(newer::ActiveCollisionTypes::from_bits_retain(types))
}

fn body_type(kind: RigidBodyType) -> newer::RigidBodyType {
    match kind {
        RigidBodyType::Dynamic => newer::RigidBodyType::Dynamic,
        RigidBodyType::Fixed => newer::RigidBodyType::Fixed,
        RigidBodyType::KinematicPositionBased => newer::RigidBodyType::KinematicPositionBased,
        RigidBodyType::KinematicVelocityBased => newer::RigidBodyType::KinematicVelocityBased,
    }
}

impl BroadPhase for Rapier036 {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        assert!(removed.is_empty(), "the scenes here remove nothing");
        let distance = params.prediction_distance() / 2.0;
        for &handle in modified {
            let Some(collider) = colliders.get(handle) else {
                continue;
            };
            let twin = self.twin(handle, collider, bodies);
            let aabb = collider.compute_collision_aabb(distance);
            let corner = |corner: Point<Real>| -> newer::Vector {
                let corner: [Real; DIM] = corner.coords.into();
                corner.into()
            };
            let aabb = newer::Aabb::new(corner(aabb.mins), corner(aabb.maxs));
            self.tree.set_aabb(&self.params, twin, aabb);
        }
        self.events.clear();
        self.tree.update(
            &self.params,
            &self.colliders,
            &self.bodies,
            &[],
            &[],
            &mut self.events,
        );
        events.extend(self.events.iter().map(|event| match event {
            newer::BroadPhasePairEvent::AddPair(pair) => {
                BroadPhasePairEvent::AddPair(self.original(*pair))
            }
            newer::BroadPhasePairEvent::DeletePair(pair) => {
                BroadPhasePairEvent::DeletePair(self.original(*pair))
            }
        }));
    }
}

#[cfg(test)]
mod tests {
    use super::super::scenes::rapier::prelude::*;
    use super::Rapier036;

    #[test]
    fn pairs_come_and_go() {
        let (mut bodies, mut colliders) = (RigidBodySet::new(), ColliderSet::new());
        // The first slot stays empty, so that twins have other handles than their originals.
        let removed = colliders.insert(ColliderBuilder::ball(0.5));
        let handles = [0, 1].map(|_| {
            let body = bodies.insert(RigidBodyBuilder::dynamic());
            colliders.insert_with_parent(ColliderBuilder::ball(0.5), body, &mut bodies)
        });
        colliders.remove(removed, &mut IslandManager::new(), &mut bodies, false);
        let mut broad_phase = Rapier036::default();
        let mut events_at = |x: Real| {
            let mut place: Vector<Real> = Vector::zeros();
            place[0] = x;
            colliders[handles[1]].set_position(place.into());
            let (params, mut events) = (IntegrationParameters::default(), Vec::new());
            broad_phase.update(&params, &colliders, &bodies, &handles, &[], &mut events);
            events
        };
        assert!(events_at(5.0).is_empty());
        let is_pair = |pair: &ColliderPair| [pair.collider1, pair.collider2] == handles;
        let events = events_at(0.9);
        assert!(matches!(&events[..], [BroadPhasePairEvent::AddPair(pair)] if is_pair(pair)));
        assert!(events_at(0.8).is_empty());
        let events = events_at(5.0);
        assert!(matches!(&events[..], [BroadPhasePairEvent::DeletePair(pair)] if is_pair(pair)));
    }
}
