//! The query tree exists from the first query on, serves all that follow, and is given up when nobody asks any more.

use crate::memory::live_bytes;
use crate::turn;

const COLLIDERS: usize = 500;

/// Less than any tree of this many colliders takes.
const LEAST: usize = 16 * COLLIDERS;

/// One source for both dimensions.
macro_rules! check {
    ($rapier:ident, $ours:ident) => {{
        use unisize::$ours::UnisizeBroadPhase;
        use $rapier::parry::query::DefaultQueryDispatcher;
        use $rapier::prelude::*;

        let _turn = turn();
        let mut broad_phase = UnisizeBroadPhase::new();
        let mut colliders = ColliderSet::new();
        let (bodies, params) = (RigidBodySet::new(), IntegrationParameters::default());
        let handles: Vec<_> = (0..COLLIDERS)
            .map(|i| {
                let place = Vector::repeat(2.0 * i as f32);
                colliders.insert(ColliderBuilder::ball(0.5).translation(place))
            })
            .collect();
        let update = |broad_phase: &mut UnisizeBroadPhase, colliders: &ColliderSet| {
            let mut events = Vec::new();
            broad_phase.update(&params, colliders, &bodies, &handles, &[], &mut events);
            assert!(events.is_empty());
        };
        let query = |broad_phase: &UnisizeBroadPhase, colliders: &ColliderSet| {
            let (dispatcher, filter) = (&DefaultQueryDispatcher, QueryFilter::default());
            let scene = broad_phase.as_query_pipeline(dispatcher, &bodies, colliders, filter);
            assert_eq!(scene.intersect_point(Point::origin()).count(), 1);
        };
        let advance = |colliders: &mut ColliderSet| {
            let last = &mut colliders[handles[COLLIDERS - 1]];
            last.set_translation(last.translation() + Vector::repeat(1.0));
        };
        update(&mut broad_phase, &colliders);
        let bare = live_bytes();
        for _ in 0..3 {
            query(&broad_phase, &colliders);
            let with_tree = live_bytes();
            assert!(with_tree > bare + LEAST, "{with_tree} after {bare} bytes");

            // Nothing has left its margin. The harness's other threads may free a name meanwhile, but not every time.
            let is_steady = (0..8).any(|_| {
                let before = live_bytes();
                for _ in 0..100 {
                    update(&mut broad_phase, &colliders);
                }
                query(&broad_phase, &colliders);
                live_bytes() == before
            });
            assert!(is_steady, "{with_tree} bytes at first");

            // It is kept when boxes change, and takes no more room but for Parry's scratch memory.
            let most = with_tree + 2 * (with_tree - bare);
            for _ in 0..1000 {
                advance(&mut colliders);
                update(&mut broad_phase, &colliders);
                query(&broad_phase, &colliders);
                assert!((bare + LEAST..most).contains(&live_bytes()));
            }

            // It is not kept for nobody.
            for _ in 0..100 {
                advance(&mut colliders);
                update(&mut broad_phase, &colliders);
            }
            assert!(live_bytes() < with_tree - LEAST);
        }
    }};
}

#[test]
fn a_tree_is_kept_while_it_is_asked_for_in_2d() {
    check!(rapier2d, rapier2d_027);
}

#[test]
fn a_tree_is_kept_while_it_is_asked_for_in_3d() {
    check!(rapier3d, rapier3d_027);
}
