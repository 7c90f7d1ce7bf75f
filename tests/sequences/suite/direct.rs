//! Sequences with hand-made lists: duplicates, foreign handles and empty lists included.

use super::checked::CheckedBroadPhase;
use super::world::{Ahead, World};
use crate::ops::Sequence;
#[cfg(test)]
use crate::ops::{Groups, NewCollider, Op, Parent, Shape, Types};

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

/// A cuboid is replaced by a ball, which moves by less than the skin of volumes. Where it was, it would have met the last ball.
#[cfg(test)]
#[test]
fn the_volume_of_a_removed_collider_is_forgotten() {
    let groups = Groups {
        memberships: u32::MAX,
        filter: u32::MAX,
    };
    let new = |shape, at| NewCollider {
        shape,
        at,
        sensor: false,
        enabled: true,
        groups,
        types: Types::All,
    };
    let cuboid = new(Shape::Cuboid([0.25; 3]), [0.0; 3]);
    let [ball, last] = [(3.0, [0.0; 3]), (0.499, [-2.5, -2.65, 0.0])];
    let [ball, last] = [ball, last].map(|(radius, at)| new(Shape::Ball(radius), at));
    play(&Sequence {
        length_unit: 10.0,
        margin: 0.1,
        filter: unisize::PairFilter::Shapes,
        updates: vec![
            vec![Op::Insert(cuboid, Parent::None)],
            vec![Op::Replace(0, ball)],
            vec![Op::Move(0, [0.01, 0.01, 0.0])],
            vec![Op::Insert(last, Parent::None)],
        ],
    });
}
