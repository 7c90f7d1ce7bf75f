//! Which pairs touch, and what begins and ends.

use std::collections::BTreeMap;

use rapier3d_036::parry::query;
use rapier3d_036::prelude::*;

/// The pairs of the broad phase, and whether they touch: a narrow phase without contact forces.
#[derive(Default)]
pub(crate) struct Touching {
    pairs: BTreeMap<(u32, u32), (ColliderPair, bool)>,
}

impl Touching {
    /// Applies the changes of the pair set, tests each pair, and returns the contacts that began or ended.
    pub(crate) fn renew(
        &mut self,
        changes: &mut Vec<BroadPhasePairEvent>,
        colliders: &ColliderSet,
    ) -> Vec<CollisionEvent> {
        let mut events = Vec::new();
        for change in changes.drain(..) {
            match change {
                BroadPhasePairEvent::AddPair(pair) => {
                    self.pairs.insert(key(&pair), (pair, false));
                }
                BroadPhasePairEvent::DeletePair(pair) => {
                    if let Some((_, true)) = self.pairs.remove(&key(&pair)) {
                        events.push(event(&pair, false));
                    }
                }
            }
        }
        for (pair, touches) in self.pairs.values_mut() {
            let [one, other] = [pair.collider1, pair.collider2].map(|handle| &colliders[handle]);
            let (one_pose, other_pose) = (one.position(), other.position());
            let test = query::intersection_test(one_pose, one.shape(), other_pose, other.shape());
            let now = test.is_ok_and(|found| found.intersecting);
            if now != *touches {
                events.push(event(pair, now));
                *touches = now;
            }
        }
        events
    }
}

/// The events in an order that does not depend on their source.
pub(crate) fn sorted(events: &[CollisionEvent]) -> Vec<(bool, [(u32, u32); 2])> {
    let mut sorted: Vec<_> = events
        .iter()
        .map(|event| {
            let mut pair = [event.collider1(), event.collider2()].map(|h| h.into_raw_parts());
            pair.sort_unstable();
            (event.started(), pair)
        })
        .collect();
    sorted.sort_unstable();
    sorted
}

fn key(pair: &ColliderPair) -> (u32, u32) {
    (
        pair.collider1.into_raw_parts().0,
        pair.collider2.into_raw_parts().0,
    )
}

fn event(pair: &ColliderPair, starts: bool) -> CollisionEvent {
    let flags = CollisionEventFlags::SENSOR;
    if starts {
        CollisionEvent::Started(pair.collider1, pair.collider2, flags)
    } else {
        CollisionEvent::Stopped(pair.collider1, pair.collider2, flags)
    }
}
