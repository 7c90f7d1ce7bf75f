//! The contacts that two narrow phases find for the pairs of two broad phases.
//!
//! Each gets the events of its broad phase, and Rapier's [`CollisionPipeline`] runs it on a copy of the same world. So only the pairs can
//! make a difference, and not the order in which the solver works.

use super::super::observed::Update;
use super::super::pairs::{self, PairEvent, Pairs, in_order};
use super::super::rapier::prelude::*;
use super::super::version::{self, BroadPhase};
use super::super::world::{Steppable, World};
use crate::Both;
use std::collections::HashSet;

/// The colliders that touch, and the sensors that are entered.
pub(super) struct Touching {
    /// The pairs with a contact that the solver would see.
    pub(super) contacts: Pairs,
    /// The pairs with a sensor that intersect.
    pub(super) intersections: Pairs,
}

impl Touching {
    /// The last findings of a narrow phase.
    pub(super) fn of(narrow_phase: &NarrowPhase) -> Self {
        let pair = |a, b| in_order(ColliderPair::new(a, b));
        let contacts = narrow_phase.contact_pairs();
        let intersections = narrow_phase.intersection_pairs();
        Self {
            contacts: contacts
                .filter(|contact| version::touches(contact))
                .map(|contact| pair(contact.collider1, contact.collider2))
                .collect(),
            intersections: intersections
                .filter(|&(_, _, intersecting)| intersecting)
                .map(|(a, b, _)| pair(a, b))
                .collect(),
        }
    }
}

/// A broad phase that repeats the events of another one.
struct Replay(Vec<PairEvent>);

impl BroadPhase for Replay {
    fn update(
        &mut self,
        _params: &IntegrationParameters,
        _colliders: &ColliderSet,
        _bodies: &RigidBodySet,
        _modified: &[ColliderHandle],
        _removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        events.extend(self.0.drain(..).map(BroadPhasePairEvent::from));
    }

    version::when_boxes_are_handed_over! {
        fn set_aabbs(&mut self, _: &IntegrationParameters, _: &[(ColliderHandle, Aabb)]) {}

        fn bvh(&self) -> &Bvh {
            unreachable!("a replay is not asked")
        }

        fn clone_box(&self) -> Box<dyn BroadPhase> {
            Box::new(Self(self.0.clone()))
        }
    }
}

/// Where colliders will be found by the next update, and with what shapes.
pub(super) struct Placed(Vec<(ColliderHandle, version::Pose, SharedShape)>);

impl Placed {
    pub(super) fn of(world: &World) -> Self {
        let place = |(handle, collider): (_, &Collider)| {
            // A body takes its colliders along at the beginning of a step.
            let body = collider.parent().and_then(|body| world.bodies.get(body));
            let pose = match (body, collider.position_wrt_parent()) {
                (Some(body), Some(local)) => *body.position() * *local,
                _ => *collider.position(),
            };
            (handle, pose, collider.shared_shape().clone())
        };
        Self(world.colliders.iter().map(place).collect())
    }

    fn restore(&self, colliders: &mut ColliderSet) {
        for (handle, pose, shape) in &self.0 {
            if let Some(collider) = colliders.get_mut(*handle) {
                collider.set_position(*pose);
                if !std::sync::Arc::ptr_eq(&collider.shared_shape().0, &shape.0) {
                    collider.set_shape(shape.clone());
                }
            }
        }
    }
}

/// A narrow phase with the events of one broad phase.
///
/// The removal of a collider ends its pairs, whatever events they had before. So the follower passes all removals first and the events after
/// them, without the events of a collider from before its removal.
#[derive(Default)]
pub(super) struct Follower {
    narrow_phase: NarrowPhase,
    /// The colliders that were removed or disabled since the last update, in order.
    removed: Vec<ColliderHandle>,
    /// The events after the last removal of either collider, in order.
    events: Vec<PairEvent>,
}

impl Follower {
    /// Collects these updates.
    pub(super) fn note(&mut self, updates: &[Update]) {
        for update in updates {
            if !update.removed.is_empty() && !self.events.is_empty() {
                let removed: HashSet<_> = update.removed.iter().collect();
                self.events.retain(|event| {
                    let pair = event.pair();
                    !removed.contains(&pair.collider1) && !removed.contains(&pair.collider2)
                });
            }
            self.removed.extend_from_slice(&update.removed);
            self.events.extend_from_slice(&update.events);
        }
    }

    /// Updates the narrow phase, with the colliders as they are or as they were placed.
    fn look(&mut self, world: &World, placed: Option<&Placed>) -> Touching {
        // Copies: Rapier 0.36 notes in the bodies which islands the contacts have joined.
        let mut copy = World {
            params: world.params,
            islands: world.islands.clone(),
            narrow_phase: std::mem::take(&mut self.narrow_phase),
            bodies: world.bodies.clone(),
            colliders: world.colliders.clone(),
            ..World::new(world.gravity)
        };
        if let Some(placed) = placed {
            placed.restore(&mut copy.colliders);
        }
        copy.narrow_phase.handle_user_changes(
            None,
            &[],
            &self.removed,
            &mut copy.colliders,
            &mut copy.bodies,
            &(),
        );
        mark_modified(&mut copy.colliders);
        let mut replay = version::install(Replay(std::mem::take(&mut self.events)));
        copy.collide(replay.for_step(), &());
        self.removed.clear();
        self.narrow_phase = copy.narrow_phase;
        Touching::of(&self.narrow_phase)
    }
}

/// The difference between the contacts and intersections of both narrow phases.
pub(super) fn difference(
    world: &World,
    placed: Option<&Placed>,
    followers: &mut Both<Follower>,
) -> Option<String> {
    let default = followers.default.look(world, placed);
    let candidate = followers.candidate.look(world, placed);
    let only = |these: &Pairs, others: &Pairs, meaning: &str| {
        pairs::difference(these, others, world, meaning, |_| true)
    };
    let differ = |default: &Pairs, candidate: &Pairs, verb: &str| {
        let missing = format!("{verb} by the default and not by the candidate");
        let surplus = format!("{verb} by the candidate and not by the default");
        only(default, candidate, &missing).or_else(|| only(candidate, default, &surplus))
    };
    differ(&default.contacts, &candidate.contacts, "touch").or_else(|| {
        differ(
            &default.intersections,
            &candidate.intersections,
            "intersect",
        )
    })
}

/// Makes Rapier recompute every contact.
fn mark_modified(colliders: &mut ColliderSet) {
    for (_, collider) in colliders.iter_mut() {
        let position = *collider.position();
        collider.set_position(position);
        // A collider may have become a sensor or ceased to be one, and only a change is noticed.
        let is_sensor = collider.is_sensor();
        collider.set_sensor(!is_sensor);
        collider.set_sensor(is_sensor);
        // A composite shape may have been replaced, which invalidates what Rapier caches with the pair.
        if !collider.shape().is_convex() {
            let shape = collider.shared_shape().clone();
            collider.set_shape(shape);
        }
    }
}
