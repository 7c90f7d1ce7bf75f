//! Sequences with hand-made lists: duplicates, foreign handles and empty lists included.

use super::checked::CheckedBroadPhase;
use super::world::{Ahead, World};
use crate::ops::Sequence;

pub(super) fn play(sequence: &Sequence) {
    let mut broad_phase = CheckedBroadPhase::new(sequence);
    let mut world = World::new(sequence.length_unit.into());
    for ops in &sequence.updates {
        for &op in ops {
            world.apply(op);
        }
        for ahead in std::mem::take(&mut world.ahead) {
            match ahead {
                Ahead::HandOver(boxes) => broad_phase.check_hand_over(&world.params, &boxes),
                Ahead::Ask => broad_phase.check_leaves(),
                Ahead::Renew(is_written) => broad_phase.renew(is_written),
            }
        }
        list_silent_removals(&mut world, &broad_phase);
        broad_phase.check_update(
            &world.params,
            &world.colliders,
            &world.bodies,
            [&world.modified, &world.removed],
            &mut Vec::new(),
        );
        world.modified.clear();
        world.removed.clear();
        world.keep();
    }
}

/// Lists the colliders that were replaced without a report, except those whose successor is listed.
fn list_silent_removals(world: &mut World, broad_phase: &CheckedBroadPhase) {
    let World {
        colliders,
        modified,
        removed,
        ..
    } = world;
    let succeeded = |index: u32| {
        let mut successors = modified.iter().filter(|h| h.into_raw_parts().0 == index);
        successors.any(|&h| colliders.get(h).is_some_and(|co| co.is_enabled()))
    };
    for handle in broad_phase.model().known() {
        if !colliders.contains(handle) && !succeeded(handle.into_raw_parts().0) {
            removed.push(handle);
        }
    }
}
