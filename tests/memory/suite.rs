//! Memory must not grow with indices of handles that do not exist. The tree for queries is built by the first query, kept for the following
//! ones, and freed when queries stop.

use super::rapier::parry::query::DefaultQueryDispatcher;
use super::rapier::prelude::*;
use super::{PairFilter, Settings, UnisizeBroadPhase, rapier};
use crate::allocations::{allocated_bytes, live_bytes, reallocations};
use crate::turn;
use desk::Desk;

#[path = "../common/desk.rs"]
#[allow(dead_code)] // Some methods are for other tests.
mod desk;

const COLLIDERS: usize = 500;

/// Fewer bytes than any tree of this many colliders takes.
const LEAST: usize = 16 * COLLIDERS;

/// The limit in bytes for one collider and a list of a few hundred handles. An array over all indices would take gigabytes.
const BOUND: usize = 64 << 10;

/// Balls that are apart, and their handles.
fn balls(count: usize) -> (Desk, Vec<ColliderHandle>) {
    let mut desk = Desk::default();
    let balls = (0..count).map(|i| desk.ball(0.5, [2.0 * i as Real, 0.0]));
    let balls = balls.collect();
    (desk, balls)
}

fn query(desk: &Desk) {
    let (dispatcher, filter) = (&DefaultQueryDispatcher, QueryFilter::default());
    let (bodies, colliders) = (&desk.bodies, &desk.colliders);
    let broad_phase = &desk.broad_phase;
    let scene = broad_phase.as_query_pipeline(dispatcher, bodies, colliders, filter);
    assert_eq!(scene.intersect_point([0.0; DIM].into()).count(), 1);
}

#[test]
fn memory_does_not_grow_with_invalid_indices() {
    let _turn = turn();
    let (mut desk, mut listed) = balls(1);
    let bogus = [1 << 16, 1 << 24, u32::MAX - 1, u32::MAX];
    let bogus = bogus
        .iter()
        .flat_map(|&index| [(index, 0), (index, u32::MAX)]);
    let bogus = bogus.map(|(index, generation)| ColliderHandle::from_raw_parts(index, generation));
    // The list is so long that colliders are not read in its order.
    let bogus: Vec<_> = bogus.cycle().take(400).collect();
    listed.extend(&bogus);
    let before = live_bytes();
    for _ in 0..10 {
        desk.update(&listed, &bogus);
    }
    let taken = live_bytes().saturating_sub(before);
    assert!(taken < BOUND, "{taken} bytes for one collider");
    assert_eq!(desk.counts(), [1, 0, 0]);
}

#[test]
fn the_tree_is_kept_while_there_are_queries() {
    let _turn = turn();
    let (mut desk, balls) = balls(COLLIDERS);
    desk.update(&balls, &[]);
    let mut place = 2.0 * COLLIDERS as Real;
    let mut advance_last = |desk: &mut Desk| {
        place += 1.0;
        desk.place(balls[COLLIDERS - 1], [place, 0.0]);
        desk.update(&balls, &[]);
    };
    let bare = live_bytes();
    for _ in 0..3 {
        query(&desk);
        let with_tree = live_bytes();
        assert!(with_tree > bare + LEAST, "{with_tree} after {bare} bytes");

        // No collider leaves its margin. Other threads of the harness may free memory meanwhile, but not every time.
        let is_steady = (0..8).any(|_| {
            let before = live_bytes();
            for _ in 0..100 {
                desk.update(&balls, &[]);
            }
            query(&desk);
            live_bytes() == before
        });
        assert!(is_steady, "{with_tree} bytes at first");

        // The tree is kept when boxes change. It grows only by the scratch memory of Parry.
        let most = with_tree + 2 * (with_tree - bare);
        for _ in 0..1000 {
            advance_last(&mut desk);
            query(&desk);
            assert!((bare + LEAST..most).contains(&live_bytes()));
        }

        // Without queries the tree is freed.
        for _ in 0..100 {
            advance_last(&mut desk);
        }
        assert!(live_bytes() < with_tree - LEAST);
    }
}

/// The shapes of three worlds: cuboids; capsules; both with balls in between.
fn kinds() -> [Vec<SharedShape>; 3] {
    let cuboid = SharedShape::new(rapier::parry::shape::Cuboid::new([0.4; DIM].into()));
    let capsule = SharedShape::capsule_y(0.3, 0.1);
    let ball = SharedShape::ball(0.4);
    let mixed = vec![ball.clone(), cuboid.clone(), ball, capsule.clone()];
    [vec![cuboid], vec![capsule], mixed]
}

/// An update without the checks of `Desk::update`, which allocate memory.
fn update_unchecked(desk: &mut Desk, listed: &[ColliderHandle]) {
    let (colliders, bodies) = (&desk.colliders, &desk.bodies);
    let events = &mut Vec::new();
    desk.broad_phase
        .update(&desk.params, colliders, bodies, listed, &[], events);
}

/// The numbers of reallocations while `count` colliders that are apart are added, `step` in each update, and while their broad phase is read
/// from a snapshot.
fn reallocated(kinds: &[SharedShape], count: usize, step: usize) -> [usize; 2] {
    let mut desk = Desk::with_settings(Settings::default().with_filter(PairFilter::Shapes));
    let types = ActiveCollisionTypes::all();
    let all: Vec<_> = (0..count)
        .map(|i| {
            let collider = ColliderBuilder::new(kinds[i % kinds.len()].clone());
            let handle = desk
                .colliders
                .insert(collider.active_collision_types(types));
            desk.place(handle, [2.0 * i as Real, 0.0]);
            handle
        })
        .collect();
    let before = reallocations();
    for listed in all.chunks(step) {
        update_unchecked(&mut desk, listed);
    }
    let while_adding = reallocations() - before;
    [while_adding, reallocated_by_reading(&desk.broad_phase)]
}

#[cfg(feature = "serde-serialize")]
fn reallocated_by_reading(broad_phase: &UnisizeBroadPhase) -> usize {
    let bytes = postcard::to_stdvec(broad_phase).unwrap();
    let before = reallocations();
    let _read: UnisizeBroadPhase = postcard::from_bytes(&bytes).unwrap();
    reallocations() - before
}

#[cfg(not(feature = "serde-serialize"))]
fn reallocated_by_reading(_: &UnisizeBroadPhase) -> usize {
    0
}

/// Balls have no half axes. Compared with them, other shapes need one more reallocation per doubling of the number of colliders.
#[test]
fn reallocations_of_volumes_grow_with_the_logarithm_of_colliders() {
    const COUNT: usize = 1 << 12;
    let _turn = turn();
    // The factor is for other threads of the harness.
    let most = 3 * COUNT.ilog2() as usize;
    let balls = [SharedShape::ball(0.4)];
    for step in [COUNT, 1] {
        let of_balls = reallocated(&balls, COUNT, step);
        for kinds in kinds() {
            let found = reallocated(&kinds, COUNT, step);
            for (found, of_balls) in found.into_iter().zip(of_balls) {
                assert!(found <= of_balls + most, "{found} instead of {of_balls}");
            }
        }
    }
}

/// Tall columns sink towards a stack of long bars, and stop before they touch one. Ahead of its motion, each column meets all bars.
#[test]
fn memory_does_not_grow_with_pairs_that_may_never_meet() {
    const COUNT: usize = 3000;
    const STEP: Real = 2.0;
    /// 4 kB per collider, which includes growing lists. The pairs ahead of the motion would take four times as much.
    const MOST: usize = COUNT << 12;
    let _turn = turn();
    let mut desk = Desk::default();
    let thin = 1e-4;
    let mut add = |x: Real, y: Real, centre| {
        let mut extents = [thin; DIM];
        extents[..2].copy_from_slice(&[x, y]);
        let shape = SharedShape::new(rapier::parry::shape::Cuboid::new(extents.into()));
        let collider = ColliderBuilder::new(shape);
        let collider = collider.active_collision_types(ActiveCollisionTypes::all());
        let handle = desk.colliders.insert(collider);
        desk.place(handle, centre);
        handle
    };
    let share = |i: usize| i as Real / COUNT as Real;
    let bars: Vec<_> = (0..COUNT / 2)
        .map(|i| add(50.0, thin, [0.0, 100.0 * share(i)]))
        .collect();
    let place = |i: usize, bottom| [80.0 * share(i) - 20.0, bottom + 50.0];
    let columns: Vec<_> = (0..COUNT / 2)
        .map(|i| add(thin, 50.0, place(i, 60.0)))
        .collect();
    desk.update(&[bars, columns.clone()].concat(), &[]);
    for step in 1..4 {
        for (i, &column) in columns.iter().enumerate() {
            desk.place(column, place(i, 60.0 - STEP * step as Real));
        }
        let before = allocated_bytes();
        update_unchecked(&mut desk, &columns);
        let allocated = allocated_bytes() - before;
        assert!(allocated < MOST, "{allocated} bytes in an update");
        assert_eq!(desk.counts(), [COUNT, 0, 0]);
    }
}
