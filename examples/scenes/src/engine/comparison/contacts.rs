//! What two narrow phases make of the pairs of two broad phases.
//!
//! Each gets the events of its broad phase and is then run by Rapier's [`CollisionPipeline`] on a copy of the same
//! world, so that nothing but the pairs can make a difference, not even the order in which the solver works.

use super::World;
use super::both::{Both, Side};
use super::journal::Journal;
use super::pair::Pair;
use super::rapier::prelude::*;
use super::version::{self, BroadPhase};

/// The colliders that touch, and the sensors that are entered.
#[derive(Default, PartialEq, Eq)]
pub(super) struct Touching {
    /// The pairs with a contact that the solver would see, sorted.
    pub(super) contacts: Vec<Pair>,
    /// The pairs with a sensor that intersect, sorted.
    pub(super) intersections: Vec<Pair>,
}

impl Touching {
    /// What a narrow phase has found last.
    pub(super) fn of(narrow_phase: &NarrowPhase) -> Self {
        let mut contacts: Vec<_> = narrow_phase
            .contact_pairs()
            .filter(|pair| version::touches(pair))
            .map(|pair| Pair::new(pair.collider1, pair.collider2))
            .collect();
        let mut intersections: Vec<_> = narrow_phase
            .intersection_pairs()
            .filter(|&(_, _, intersecting)| intersecting)
            .map(|(a, b, _)| Pair::new(a, b))
            .collect();
        contacts.sort_unstable();
        intersections.sort_unstable();
        Self {
            contacts,
            intersections,
        }
    }

    /// All of them, contacts first.
    pub(super) fn all(&self) -> impl Iterator<Item = Pair> + '_ {
        self.contacts.iter().chain(&self.intersections).copied()
    }
}

/// A broad phase that reports what another has reported before.
struct Replay(Vec<BroadPhasePairEvent>);

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
        events.append(&mut self.0);
    }

    version::when_boxes_are_handed_over! {
        fn set_aabbs(&mut self, _: &IntegrationParameters, _: &ColliderSet, _: &[(ColliderHandle, Aabb)]) {}

        fn bvh(&self) -> &Bvh {
            unreachable!("a replay is not asked")
        }

        fn clone_box(&self) -> Box<dyn BroadPhase> {
            let events = self.0.iter().map(super::PairEvent::from);
            Box::new(Self(events.map(Into::into).collect()))
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

/// The two narrow phases.
#[derive(Default)]
pub(super) struct ContactCheck {
    narrow_phases: Both<NarrowPhase>,
}

impl ContactCheck {
    /// Brings both narrow phases up to date, and says how their results differ, if they do, with the colliders as they are or as they
    /// were placed.
    pub(super) fn check(
        &mut self,
        world: &World,
        placed: Option<&Placed>,
        journals: &mut Both<Journal>,
        hooks: &dyn PhysicsHooks,
    ) -> Option<String> {
        for side in [Side::Default, Side::Candidate] {
            // A copy for each: Rapier 0.36 notes in the bodies which islands the contacts have joined.
            let mut colliders = world.colliders.clone();
            let mut bodies = world.bodies.clone();
            if let Some(placed) = placed {
                placed.restore(&mut colliders);
            }
            let narrow_phase = &mut self.narrow_phases[side];
            let journal = &mut journals[side];
            narrow_phase.handle_user_changes(
                None,
                &[],
                &journal.removed,
                &mut colliders,
                &mut bodies,
                &(),
            );
            mark_modified(&mut colliders);
            let replay = Replay(journal.events.drain(..).map(Into::into).collect());
            version::detect(
                world,
                replay,
                narrow_phase,
                &mut bodies,
                &mut colliders,
                hooks,
            );
            journal.clear();
        }
        let touching = Both::of(|side| Touching::of(&self.narrow_phases[side]));
        let contacts = Both::of(|side| touching[side].contacts.as_slice());
        let intersections = Both::of(|side| touching[side].intersections.as_slice());
        difference("touch", contacts, world)
            .or_else(|| difference("intersect", intersections, world))
    }
}

/// Makes Rapier recompute every contact, whatever was modified since the last check.
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

/// The first pair that is in one of two sorted lists only, as a sentence.
fn difference(verb: &str, pairs: Both<&[Pair]>, world: &World) -> Option<String> {
    let only = Both::of(|side| {
        let missing = |pair: &&Pair| pairs[side.other()].binary_search(pair).is_err();
        pairs[side].iter().filter(missing).collect::<Vec<_>>()
    });
    let side = if only.default.is_empty() {
        Side::Candidate
    } else {
        Side::Default
    };
    let pair = only[side].first()?;
    Some(format!(
        "{} {verb} with the pairs of {}, and do not with those of {} ({} such in all)",
        pair.describe(world),
        side.name(),
        side.other().name(),
        only.default.len() + only.candidate.len(),
    ))
}
