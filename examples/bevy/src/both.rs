//! A broad phase that is both: unisize, whose events it passes on, and Rapier's own, fed with the same, to compare.

use std::collections::HashSet;

use anyhow::{Result, ensure};
use bevy::prelude::*;
use bevy_rapier3d::prelude::RapierContextSimulation;
use bevy_rapier3d::rapier::dynamics::{IntegrationParameters, RigidBodySet};
use bevy_rapier3d::rapier::geometry::{
    Aabb, BroadPhasePairEvent, Bvh, ColliderHandle, ColliderSet, CustomBroadPhase,
    DefaultBroadPhase,
};
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
}

impl Both {
    /// Fails if the two do not hold the same pairs.
    pub(crate) fn compare(&self) -> Result<()> {
        let pairs = self.unisize.pairs();
        let pairs: HashSet<_> = pairs
            .map(|found| pair(found.collider1, found.collider2))
            .collect();
        let missing: Vec<_> = self.pairs.difference(&pairs).take(3).collect();
        let spurious: Vec<_> = pairs.difference(&self.pairs).take(3).collect();
        ensure!(
            missing.is_empty() && spurious.is_empty(),
            "the pairs are different: {missing:?} are missing, {spurious:?} should not be there"
        );
        Ok(())
    }
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
        let mut own = vec![];
        self.default.update(
            params,
            colliders,
            bodies,
            modified_colliders,
            removed_colliders,
            &mut own,
        );
        for event in own {
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
            .retain(|pair| !pair.iter().any(|handle| removed_colliders.contains(handle)));
        self.unisize.update(
            params,
            colliders,
            bodies,
            modified_colliders,
            removed_colliders,
            events,
        );
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
