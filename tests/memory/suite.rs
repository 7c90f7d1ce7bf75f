//! Handles may have any index, and memory must not grow with indices that were never given out. The query tree exists from the first query
//! on, serves all that follow, and is given up when nobody asks any more.

use super::UnisizeBroadPhase;
use super::rapier::parry::query::DefaultQueryDispatcher;
use super::rapier::prelude::*;
use crate::memory::live_bytes;
use crate::turn;

const COLLIDERS: usize = 500;

/// Less than any tree of this many colliders takes.
const LEAST: usize = 16 * COLLIDERS;

/// The most that one collider and a list of a few hundred handles may take. An array of all indices would take gigabytes.
const BOUND: usize = 64 << 10;

/// What updates and queries are given, and all colliders.
#[derive(Default)]
struct Given {
    params: IntegrationParameters,
    bodies: RigidBodySet,
    colliders: ColliderSet,
    handles: Vec<ColliderHandle>,
}

impl Given {
    fn new(count: usize) -> Self {
        let mut given = Self::default();
        for i in 0..count {
            let place = [2.0 * i as Real; DIM].into();
            let ball = ColliderBuilder::ball(0.5).translation(place);
            given.handles.push(given.colliders.insert(ball));
        }
        given
    }

    fn update(&self, broad_phase: &mut UnisizeBroadPhase, removed: &[ColliderHandle]) {
        let (mut events, listed) = (Vec::new(), &self.handles);
        let (bodies, colliders) = (&self.bodies, &self.colliders);
        broad_phase.update(
            &self.params,
            colliders,
            bodies,
            listed,
            removed,
            &mut events,
        );
        assert!(events.is_empty());
    }

    fn query(&self, broad_phase: &UnisizeBroadPhase) {
        let (dispatcher, filter) = (&DefaultQueryDispatcher, QueryFilter::default());
        let (bodies, colliders) = (&self.bodies, &self.colliders);
        let scene = broad_phase.as_query_pipeline(dispatcher, bodies, colliders, filter);
        assert_eq!(scene.intersect_point([0.0; DIM].into()).count(), 1);
    }

    fn advance_last(&mut self) {
        let last = &mut self.colliders[self.handles[COLLIDERS - 1]];
        let mut place: [Real; DIM] = last.position().translation.into();
        place[0] += 1.0;
        last.set_translation(place.into());
    }
}

#[test]
fn memory_does_not_follow_bogus_indices() {
    let _turn = turn();
    let mut given = Given::new(1);
    let mut broad_phase = UnisizeBroadPhase::new();
    let bogus = [1 << 16, 1 << 24, u32::MAX - 1, u32::MAX];
    let bogus = bogus
        .iter()
        .flat_map(|&index| [(index, 0), (index, u32::MAX)]);
    let bogus = bogus.map(|(index, generation)| ColliderHandle::from_raw_parts(index, generation));
    // Long enough that colliders are no longer read in the order of the list.
    let bogus: Vec<_> = bogus.cycle().take(400).collect();
    given.handles.extend(&bogus);
    let before = live_bytes();
    for _ in 0..10 {
        given.update(&mut broad_phase, &bogus);
    }
    let taken = live_bytes().saturating_sub(before);
    assert!(taken < BOUND, "{taken} bytes for one collider");
    assert_eq!(broad_phase.stats().proxies, 1);
    broad_phase.validate();
}

#[test]
fn a_tree_is_kept_while_it_is_asked_for() {
    let _turn = turn();
    let mut given = Given::new(COLLIDERS);
    let mut broad_phase = UnisizeBroadPhase::new();
    given.update(&mut broad_phase, &[]);
    let bare = live_bytes();
    for _ in 0..3 {
        given.query(&broad_phase);
        let with_tree = live_bytes();
        assert!(with_tree > bare + LEAST, "{with_tree} after {bare} bytes");

        // Nothing has left its margin. The harness's other threads may free a name meanwhile, but not every time.
        let is_steady = (0..8).any(|_| {
            let before = live_bytes();
            for _ in 0..100 {
                given.update(&mut broad_phase, &[]);
            }
            given.query(&broad_phase);
            live_bytes() == before
        });
        assert!(is_steady, "{with_tree} bytes at first");

        // It is kept when boxes change, and takes no more room but for Parry's scratch memory.
        let most = with_tree + 2 * (with_tree - bare);
        for _ in 0..1000 {
            given.advance_last();
            given.update(&mut broad_phase, &[]);
            given.query(&broad_phase);
            assert!((bare + LEAST..most).contains(&live_bytes()));
        }

        // It is not kept for nobody.
        for _ in 0..100 {
            given.advance_last();
            given.update(&mut broad_phase, &[]);
        }
        assert!(live_bytes() < with_tree - LEAST);
    }
}
