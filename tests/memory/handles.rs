//! Handles may have any index; memory must not grow with indices that were never given out.

use crate::memory::live_bytes;
use crate::turn;

/// The most that one collider and a list of a few hundred handles may take. An array of all indices would take gigabytes.
const BOUND: usize = 64 << 10;

/// One source for both dimensions.
macro_rules! check {
    ($rapier:ident, $ours:ident) => {{
        use unisize::$ours::UnisizeBroadPhase;
        use $rapier::prelude::*;

        let _turn = turn();
        let mut broad_phase = UnisizeBroadPhase::new();
        let mut colliders = ColliderSet::new();
        let ball = colliders.insert(ColliderBuilder::ball(0.5));
        let (bodies, params) = (RigidBodySet::new(), IntegrationParameters::default());
        let bogus: Vec<_> = [1 << 16, 1 << 24, u32::MAX - 1, u32::MAX]
            .iter()
            .flat_map(|&index| [(index, 0), (index, u32::MAX)])
            .map(|(index, generation)| ColliderHandle::from_raw_parts(index, generation))
            // Long enough that colliders are no longer read in the order of the list.
            .cycle()
            .take(400)
            .chain([ball])
            .collect();
        let before = live_bytes();
        for _ in 0..10 {
            let mut events = Vec::new();
            broad_phase.update(&params, &colliders, &bodies, &bogus, &bogus, &mut events);
            assert!(events.is_empty());
        }
        let taken = live_bytes().saturating_sub(before);
        assert!(taken < BOUND, "{taken} bytes for one collider");
        assert_eq!(broad_phase.stats().proxies, 1);
        broad_phase.validate();
    }};
}

#[test]
fn memory_does_not_follow_bogus_indices_in_2d() {
    check!(rapier2d, rapier2d_027);
}

#[test]
fn memory_does_not_follow_bogus_indices_in_3d() {
    check!(rapier3d, rapier3d_027);
}
