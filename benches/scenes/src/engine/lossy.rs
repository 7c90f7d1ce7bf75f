//! A broad phase that loses pairs, which a measurement of accuracy has to notice.

use super::observed::Observed;
use super::pairs::PairEvent;
use super::version::BroadPhase;

/// Wraps a broad phase so that about one in `one_in` of its pairs is never reported.
///
/// The handles of a pair and the seed decide alone whether it is lost: a lost pair stays lost while it is held, and whenever it
/// comes back.
pub fn lossy<B: BroadPhase>(inner: B, one_in: u32, seed: u64) -> Observed<B> {
    Observed::new(inner).repeating(move |event| {
        let is_lost = hash(event, seed) % u64::from(one_in.max(1)) == 0;
        usize::from(!is_lost)
    })
}

/// A number for a pair, whichever of the two comes first.
fn hash(event: PairEvent, seed: u64) -> u64 {
    let pair = event.pair();
    let mut ends = [pair.collider1, pair.collider2].map(|handle| {
        let (index, generation) = handle.into_raw_parts();
        u64::from(generation) << 32 | u64::from(index)
    });
    ends.sort_unstable();
    ends.iter().fold(mix(seed), |hash, end| mix(hash ^ end))
}

/// The output function of the generator SplitMix64, which makes neighbouring numbers unlike each other.
fn mix(number: u64) -> u64 {
    let number = number.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let number = (number ^ number >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let number = (number ^ number >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
    number ^ number >> 31
}

#[cfg(test)]
mod tests {
    use super::super::rapier::prelude::*;
    use super::super::space::{Vector, along};
    use super::super::version::{BroadPhase, OwnBroadPhase};
    use super::super::world::World;
    use super::{Observed, lossy};
    use std::collections::HashSet;

    const BALLS: usize = 20_001;

    /// Balls in a row, of which neighbours overlap.
    fn row() -> (World, Vec<ColliderHandle>) {
        let mut world = World::new(Vector::default());
        for i in 0..BALLS {
            let ball = ColliderBuilder::ball(0.6).translation(along(0, i as Real));
            world.insert(RigidBodyBuilder::dynamic(), ball);
        }
        let handles = world.colliders.iter().map(|(handle, _)| handle).collect();
        (world, handles)
    }

    fn update(broad_phase: &mut Observed<impl BroadPhase>, world: &World, list: &[ColliderHandle]) {
        let (params, colliders, bodies) = (&world.params, &world.colliders, &world.bodies);
        broad_phase.update(params, colliders, bodies, list, &[], &mut Vec::new());
    }

    #[test]
    fn about_the_share_is_lost_and_a_seed_decides_which() {
        let (world, handles) = row();
        let held = |one_in, seed| -> HashSet<ColliderPair> {
            let lossy = lossy(OwnBroadPhase::new(), one_in, seed);
            let mut broad_phase = Observed::new(lossy).with_held();
            update(&mut broad_phase, &world, &handles);
            broad_phase.held().clone()
        };
        for seed in 0..3 {
            // Twenty are expected, and two thousand.
            let lost = |one_in| BALLS - 1 - held(one_in, seed).len();
            assert!((5..=40).contains(&lost(1000)), "{}", lost(1000));
            assert!((1850..=2150).contains(&lost(10)), "{}", lost(10));
        }
        assert_eq!(held(10, 1), held(10, 1));
        assert_ne!(held(10, 1), held(10, 2));
    }

    #[test]
    fn a_lost_pair_ends_without_an_event() {
        let (mut world, handles) = row();
        let lossy = lossy(OwnBroadPhase::new(), 10, 7);
        let mut broad_phase = Observed::new(lossy).with_held();
        update(&mut broad_phase, &world, &handles);
        for (index, &handle) in handles.iter().enumerate() {
            world.colliders[handle].set_translation(along(0, 3.0 * index as Real));
        }
        update(&mut broad_phase, &world, &handles);
        assert_eq!(broad_phase.held_fault(), None);
        assert!(broad_phase.held().is_empty());
    }
}
