//! What a user can see of a world after a step, in a canonical order.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Mutex;

use super::World;
use super::rapier::prelude::*;
use super::scenes::{Pose, Vector, own, touches};
use super::version::{self, origin};

/// Two colliders, the smaller handle first.
pub(crate) type Pair = [(u32, u32); 2];

pub(crate) fn pair(a: ColliderHandle, b: ColliderHandle) -> Pair {
    let mut pair = [a.into_raw_parts(), b.into_raw_parts()];
    pair.sort_unstable();
    pair
}

/// A collision or contact-force event.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Event {
    Started(Pair, u32),
    Stopped(Pair, u32),
    /// With the bits of the total force.
    Force(Pair, u64),
}

/// An event handler that keeps the events.
#[derive(Default)]
pub(crate) struct EventLog(pub(crate) Mutex<Vec<Event>>);

impl EventLog {
    fn push(&self, event: Event) {
        self.0.lock().expect("no handler panics").push(event);
    }
}

impl EventHandler for EventLog {
    fn handle_collision_event(
        &self,
        _: &RigidBodySet,
        _: &ColliderSet,
        event: CollisionEvent,
        _: Option<&ContactPair>,
    ) {
        self.push(match event {
            CollisionEvent::Started(a, b, flags) => Event::Started(pair(a, b), flags.bits()),
            CollisionEvent::Stopped(a, b, flags) => Event::Stopped(pair(a, b), flags.bits()),
        });
    }

    fn handle_contact_force_event(
        &self,
        _: Real,
        _: &RigidBodySet,
        _: &ColliderSet,
        contact_pair: &ContactPair,
        total_force: Real,
    ) {
        let pair = pair(contact_pair.collider1, contact_pair.collider2);
        self.push(Event::Force(pair, f64::from(total_force).to_bits()));
    }

    version::events_of_soft_bodies!();
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Snapshot {
    /// The pairs with an active contact.
    pub(crate) contacts: BTreeSet<Pair>,
    /// The pairs with a sensor that intersect.
    pub(crate) intersections: BTreeSet<Pair>,
    /// The events of the step, sorted.
    pub(crate) events: Vec<Event>,
    /// The bodies that sleep.
    pub(crate) asleep: BTreeSet<u32>,
    /// Every body's pose, and its velocity.
    pub(crate) poses: BTreeMap<u32, (Pose, Vector)>,
}

/// The pairs with an active contact.
pub(crate) fn contacts(narrow_phase: &NarrowPhase) -> BTreeSet<Pair> {
    let contacts = narrow_phase.contact_pairs();
    let contacts = contacts.filter(|contact| touches(contact));
    contacts
        .map(|contact| pair(contact.collider1, contact.collider2))
        .collect()
}

impl Snapshot {
    pub(crate) fn of(world: &World, log: EventLog) -> Self {
        let intersections = world.narrow_phase.intersection_pairs();
        let intersections = intersections.filter(|&(.., intersecting)| intersecting);
        let bodies = || {
            let bodies = world.bodies.iter();
            bodies.map(|(handle, body)| (handle.into_raw_parts().0, body))
        };
        let asleep = bodies().filter(|(_, body)| body.is_sleeping());
        let pose = |body: &RigidBody| (*body.position(), own(body.linvel()));
        let poses = bodies().map(|(index, body)| (index, pose(body)));
        let mut events = log.0.into_inner().expect("no handler panics");
        events.sort_unstable();
        Self {
            contacts: contacts(&world.narrow_phase),
            intersections: intersections.map(|(a, b, _)| pair(a, b)).collect(),
            events,
            asleep: asleep.map(|(index, _)| index).collect(),
            poses: poses.collect(),
        }
    }

    pub(crate) fn touches(&self, a: ColliderHandle, b: ColliderHandle) -> bool {
        self.contacts.contains(&pair(a, b))
    }

    pub(crate) fn intersects(&self, a: ColliderHandle, b: ColliderHandle) -> bool {
        self.intersections.contains(&pair(a, b))
    }

    pub(crate) fn sleeps(&self, body: RigidBodyHandle) -> bool {
        self.asleep.contains(&body.into_raw_parts().0)
    }

    pub(crate) fn height(&self, body: RigidBodyHandle) -> Real {
        origin(&self.poses[&body.into_raw_parts().0].0).y
    }

    pub(crate) fn started(&self, a: ColliderHandle, b: ColliderHandle) -> bool {
        self.events.contains(&Event::Started(pair(a, b), 0))
    }

    /// Whether the two stopped touching, because of a removal or not.
    pub(crate) fn stopped(&self, a: ColliderHandle, b: ColliderHandle, removed: bool) -> bool {
        let flags = match removed {
            true => CollisionEventFlags::REMOVED,
            false => CollisionEventFlags::empty(),
        };
        self.events
            .contains(&Event::Stopped(pair(a, b), flags.bits()))
    }
}
