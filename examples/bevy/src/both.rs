//! A broad phase that is both: unisize, whose events it passes on, and Rapier's own, fed with the same, to compare. By default unisize
//! holds fewer pairs than Rapier's own, for it leaves out those whose shapes are apart.

use std::collections::HashSet;

use bevy::prelude::*;
use bevy_rapier3d::prelude::RapierContextSimulation;
use bevy_rapier3d::rapier::dynamics::{IntegrationParameters, RigidBodySet};
use bevy_rapier3d::rapier::geometry::{
    Aabb, BroadPhasePairEvent, Bvh, ColliderHandle, ColliderSet, CustomBroadPhase,
    DefaultBroadPhase, PipelineInput,
};
use bevy_rapier3d::rapier::parry::query;
use unisize::rapier3d_036::UnisizeBroadPhase;

/// Puts [`Both`] into every Rapier context when it is made.
pub(crate) struct BothPlugin;

impl Plugin for BothPlugin {
    fn build(&self, app: &mut App) {
        app.add_observer(
            |added: On<Add<RapierContextSimulation>>,
             mut contexts: Query<&mut RapierContextSimulation>| {
                if let Ok(mut context) = contexts.get_mut(added.entity) {
                    context.broad_phase = DefaultBroadPhase::custom(Both::default());
                }
            },
        );
    }
}

/// Two colliders, in order.
pub(crate) fn pair(first: ColliderHandle, second: ColliderHandle) -> [ColliderHandle; 2] {
    let mut pair = [first, second];
    pair.sort_unstable_by_key(|handle| handle.into_raw_parts());
    pair
}

/// Both broad phases, and the pairs that Rapier's own has reported.
#[derive(Clone, Default)]
pub(crate) struct Both {
    unisize: UnisizeBroadPhase,
    default: DefaultBroadPhase,
    pairs: HashSet<[ColliderHandle; 2]>,
    fault: Option<String>,
}

impl Both {
    /// How many pairs unisize holds, and how many Rapier's own.
    pub(crate) fn counts(&self) -> [usize; 2] {
        [self.unisize.pairs().count(), self.pairs.len()]
    }

    /// What was wrong with the pairs of the first update that had a fault.
    pub(crate) fn fault(&self) -> Option<&str> {
        self.fault.as_deref()
    }

    /// Updates Rapier's own, and keeps its pairs.
    fn update_own(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
    ) {
        let mut events = vec![];
        self.default
            .update(params, colliders, bodies, modified, removed, &mut events);
        for event in events {
            match event {
                BroadPhasePairEvent::AddPair(added) => {
                    self.pairs.insert(pair(added.collider1, added.collider2));
                }
                BroadPhasePairEvent::DeletePair(deleted) => {
                    self.pairs
                        .remove(&pair(deleted.collider1, deleted.collider2));
                }
            }
        }
        // Those of removed colliders end without an event.
        self.pairs
            .retain(|pair| !pair.iter().any(|handle| removed.contains(handle)));
    }

    /// Notes the first fault.
    fn check(&mut self, colliders: &ColliderSet) {
        if self.fault.is_none() {
            self.fault = self.compare(colliders);
        }
    }

    /// Every pair of unisize must be one of Rapier's own, and every other one of Rapier's must be of two colliders that are apart.
    fn compare(&self, colliders: &ColliderSet) -> Option<String> {
        let held: HashSet<_> = self
            .unisize
            .pairs()
            .map(|held| pair(held.collider1, held.collider2))
            .collect();
        if let Some(spurious) = held.difference(&self.pairs).next() {
            return Some(format!("Rapier's own does not hold {spurious:?}"));
        }
        let missing = self
            .pairs
            .difference(&held)
            .find(|pair| !are_apart(colliders, **pair))?;
        Some(format!("{missing:?} touch, and unisize does not hold them"))
    }
}

/// By Parry's exact distance; whatever has none is not.
fn are_apart(colliders: &ColliderSet, pair: [ColliderHandle; 2]) -> bool {
    let [first, second] = pair.map(|handle| colliders.get(handle));
    let (Some(first), Some(second)) = (first, second) else {
        return false;
    };
    let distance = query::distance(
        first.position(),
        first.shape(),
        second.position(),
        second.shape(),
    );
    distance.is_ok_and(|between| between.distance > 0.0)
}

impl CustomBroadPhase for Both {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified_colliders: &[ColliderHandle],
        removed_colliders: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        self.update_own(
            params,
            colliders,
            bodies,
            modified_colliders,
            removed_colliders,
        );
        self.unisize.update(
            params,
            colliders,
            bodies,
            modified_colliders,
            removed_colliders,
            events,
        );
        self.check(colliders);
    }

    fn update_in_pipeline(&mut self, input: &PipelineInput, events: &mut Vec<BroadPhasePairEvent>) {
        self.update_own(
            input.params,
            input.colliders,
            input.bodies,
            input.modified,
            input.removed,
        );
        CustomBroadPhase::update_in_pipeline(&mut self.unisize, input, events);
        self.check(input.colliders);
    }

    fn visit_unreported(&self, visit: &mut dyn FnMut(ColliderHandle, Option<ColliderHandle>)) {
        self.unisize.visit_unreported(visit);
    }

    fn is_new(&self) -> bool {
        self.unisize.is_new()
    }

    fn set_aabb(&mut self, params: &IntegrationParameters, handle: ColliderHandle, aabb: Aabb) {
        self.default.set_aabb(params, handle, aabb);
        CustomBroadPhase::set_aabb(&mut self.unisize, params, handle, aabb);
    }

    fn bvh(&self) -> &Bvh {
        self.unisize.bvh()
    }

    fn clone_box(&self) -> Box<dyn CustomBroadPhase> {
        Box::new(self.clone())
    }
}
