//! The query tree exists from the first query until a box changes.

use crate::memory::live_bytes;
use crate::turn;

const COLLIDERS: usize = 500;

/// Less than any tree of this many colliders takes.
const LEAST: usize = 16 * COLLIDERS;

/// One source for both dimensions.
macro_rules! check {
    ($rapier:ident) => {{
        use unisize::$rapier::UnisizeBroadPhase;
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
        update(&mut broad_phase, &colliders);
        let bare = live_bytes();
        for _ in 0..3 {
            query(&broad_phase, &colliders);
            let with_tree = live_bytes();
            assert!(with_tree > bare + LEAST, "{with_tree} after {bare} bytes");

            // Nothing has left its margin.
            update(&mut broad_phase, &colliders);
            assert_eq!(live_bytes(), with_tree);
            query(&broad_phase, &colliders);
            assert_eq!(live_bytes(), with_tree);

            let last = &mut colliders[handles[COLLIDERS - 1]];
            last.set_translation(last.translation() + Vector::repeat(1.0));
            update(&mut broad_phase, &colliders);
            assert!(live_bytes() < with_tree - LEAST);
        }
    }};
}

#[test]
fn one_tree_until_a_box_changes_in_2d() {
    check!(rapier2d);
}

#[test]
fn one_tree_until_a_box_changes_in_3d() {
    check!(rapier3d);
}
