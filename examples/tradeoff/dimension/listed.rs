//! A broad phase that takes down which colliders it was given, and puts its events in order.

use super::scenes::rapier::prelude::*;

/// A broad phase that takes down which colliders it was given, and puts its events in order.
///
/// The solver's result depends on the order of events in its last bits, and Rapier's own broad phase reports ends of
/// pairs in that of a hash map with a random seed. In order, a simulation can be had again.
pub(super) struct Listed {
    inner: Box<dyn BroadPhase>,
    /// Colliders that were listed as modified, each once for every time, since this was last emptied.
    pub(super) modified: Vec<ColliderHandle>,
}

impl Listed {
    pub(super) fn new(inner: Box<dyn BroadPhase>) -> Self {
        Self {
            inner,
            modified: Vec::new(),
        }
    }
}

impl BroadPhase for Listed {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        let inner = &mut self.inner;
        inner.update(params, colliders, bodies, modified, removed, events);
        self.modified.extend(modified);
        events.sort_by_key(|event| {
            let (is_end, pair) = match event {
                BroadPhasePairEvent::AddPair(pair) => (false, pair),
                BroadPhasePairEvent::DeletePair(pair) => (true, pair),
            };
            let handles = [pair.collider1, pair.collider2].map(ColliderHandle::into_raw_parts);
            (is_end, handles)
        });
    }
}
