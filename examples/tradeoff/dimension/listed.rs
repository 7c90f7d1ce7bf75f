//! A broad phase that records the colliders it is given and sorts its events.

use super::scenes::rapier::prelude::*;

/// A broad phase that records the colliders it is given and sorts its events.
///
/// The last bits of the solver's result depend on the order of events, and Rapier's own broad phase ends pairs in the order
/// of a hash map with a random seed. With sorted events, a simulation is reproducible.
pub(super) struct Listed {
    inner: Box<dyn BroadPhase>,
    /// The colliders listed as modified since this was last cleared, with repetitions.
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
