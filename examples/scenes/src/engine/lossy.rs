//! A broad phase that loses pairs: what a measurement of accuracy has to notice.

use super::rapier::prelude::*;
use super::version::{self, BroadPhase};

/// A broad phase that never reports some of the pairs that another one finds.
///
/// Which pairs are lost depends on their handles and on a seed alone: a pair that is lost is lost for as long as it is
/// held, and whenever it comes back.
#[derive(Clone)]
pub struct Lossy<B> {
    inner: B,
    one_in: u64,
    seed: u64,
    /// How many new pairs were found.
    pub found: usize,
    /// How many of them were lost.
    pub lost: usize,
}

impl<B> Lossy<B> {
    /// Loses about one of this many pairs.
    pub fn new(inner: B, one_in: u32, seed: u64) -> Self {
        Self {
            inner,
            one_in: one_in.max(1).into(),
            seed,
            found: 0,
            lost: 0,
        }
    }

    fn loses(&self, event: &BroadPhasePairEvent) -> bool {
        let (BroadPhasePairEvent::AddPair(pair) | BroadPhasePairEvent::DeletePair(pair)) = event;
        let mut ends = [pair.collider1, pair.collider2].map(|handle| {
            let (index, generation) = handle.into_raw_parts();
            u64::from(generation) << 32 | u64::from(index)
        });
        // Whichever of the two comes first.
        ends.sort_unstable();
        let hash = ends
            .iter()
            .fold(mix(self.seed), |hash, end| mix(hash ^ end));
        hash % self.one_in == 0
    }
}

/// The output function of the generator SplitMix64, which makes neighbouring numbers unlike each other.
fn mix(number: u64) -> u64 {
    let number = number.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let number = (number ^ number >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let number = (number ^ number >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
    number ^ number >> 31
}

impl<B: BroadPhase + Clone + 'static> BroadPhase for Lossy<B> {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        let first = events.len();
        self.inner
            .update(params, colliders, bodies, modified, removed, events);
        for event in events.split_off(first) {
            let (is_new, is_lost) = (
                matches!(event, BroadPhasePairEvent::AddPair(_)),
                self.loses(&event),
            );
            self.found += usize::from(is_new);
            self.lost += usize::from(is_new && is_lost);
            if !is_lost {
                events.push(event);
            }
        }
    }

    version::when_boxes_are_handed_over! {
        fn set_aabbs(&mut self, params: &IntegrationParameters, colliders: &ColliderSet, boxes: &[(ColliderHandle, Aabb)]) {
            self.inner.set_aabbs(params, colliders, boxes);
        }

        fn note_changes(&mut self, reinserted: &[ColliderHandle], unmoved: &[ColliderHandle]) {
            self.inner.note_changes(reinserted, unmoved);
        }

        fn bvh(&self) -> &Bvh {
            self.inner.bvh()
        }

        fn clone_box(&self) -> Box<dyn BroadPhase> {
            Box::new(self.clone())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::observed::{Observed, PairEvent};
    use super::super::rapier::prelude::*;
    use super::super::space::{Vector, along};
    use super::super::version::{BroadPhase, OwnBroadPhase};
    use super::super::world::World;
    use super::Lossy;

    const BALLS: usize = 20_001;

    /// Balls in a row, of which neighbours overlap.
    fn row() -> (World, Vec<ColliderHandle>) {
        let mut world = World::new(Vector::default());
        let handles = (0..BALLS).map(|i| {
            let ball = ColliderBuilder::ball(0.6).translation(along(0, i as Real));
            let body = world.bodies.insert(RigidBodyBuilder::dynamic());
            let World {
                bodies, colliders, ..
            } = &mut world;
            colliders.insert_with_parent(ball, body, bodies)
        });
        let handles = handles.collect();
        (world, handles)
    }

    /// What is reported of these colliders.
    fn events(
        broad_phase: &mut dyn BroadPhase,
        world: &World,
        listed: &[ColliderHandle],
    ) -> Vec<PairEvent> {
        let (params, colliders, bodies) = (&world.params, &world.colliders, &world.bodies);
        let mut events = Vec::new();
        broad_phase.update(params, colliders, bodies, listed, &[], &mut events);
        events.iter().map(PairEvent::from).collect()
    }

    #[test]
    fn about_the_share_is_lost_and_a_seed_decides_which() {
        let (world, handles) = row();
        let added = |one_in, seed| {
            let mut lossy = Lossy::new(OwnBroadPhase::new(), one_in, seed);
            let mut pairs: Vec<_> = events(&mut lossy, &world, &handles)
                .into_iter()
                .map(|event| {
                    let pair = event.pair();
                    let mut ends = [pair.collider1, pair.collider2];
                    ends.sort_by_key(|end| end.into_raw_parts());
                    ends
                })
                .collect();
            assert_eq!(lossy.found, BALLS - 1);
            assert_eq!(lossy.lost, BALLS - 1 - pairs.len());
            pairs.sort_by_key(|ends| ends.map(ColliderHandle::into_raw_parts));
            pairs
        };
        for seed in 0..3 {
            // Twenty are expected, and two thousand.
            let lost = |one_in| BALLS - 1 - added(one_in, seed).len();
            assert!((5..=40).contains(&lost(1000)), "{}", lost(1000));
            assert!((1850..=2150).contains(&lost(10)), "{}", lost(10));
        }
        assert_eq!(added(10, 1), added(10, 1));
        assert_ne!(added(10, 1), added(10, 2));
    }

    #[test]
    fn a_lost_pair_ends_without_an_event() {
        let (mut world, handles) = row();
        let lossy = Lossy::new(OwnBroadPhase::new(), 10, 7);
        let mut observed = Observed::new(lossy).with_held();
        events(&mut observed, &world, &handles);
        assert_eq!(
            observed.held().len(),
            observed.inner.found - observed.inner.lost
        );
        for (index, &handle) in handles.iter().enumerate() {
            world.colliders[handle].set_translation(along(0, 3.0 * index as Real));
        }
        let ended = events(&mut observed, &world, &handles);
        assert!(ended.iter().all(|event| !event.is_add()));
        assert_eq!(observed.held_fault(), None);
        assert!(observed.held().is_empty());
    }
}
