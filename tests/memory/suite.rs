//! Handles may have any index, and memory must not grow with indices that were never given out. The query tree exists from the first query
//! on, serves all that follow, and is given up when nobody asks any more.

use super::rapier::parry::query::DefaultQueryDispatcher;
use super::rapier::prelude::*;
use super::{PairFilter, Settings, UnisizeBroadPhase, rapier};
use crate::allocations::{allocated_bytes, live_bytes, reallocations};
use crate::turn;
use desk::Desk;

#[path = "../common/desk.rs"]
#[allow(dead_code)] // Settings stay as they are.
mod desk;

const COLLIDERS: usize = 500;

/// Less than any tree of this many colliders takes.
const LEAST: usize = 16 * COLLIDERS;

/// The most that one collider and a list of a few hundred handles may take. An array of all indices would take gigabytes.
const BOUND: usize = 64 << 10;

/// Balls that do not meet, and their handles.
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
fn memory_does_not_follow_bogus_indices() {
    let _turn = turn();
    let (mut desk, mut listed) = balls(1);
    let bogus = [1 << 16, 1 << 24, u32::MAX - 1, u32::MAX];
    let bogus = bogus
        .iter()
        .flat_map(|&index| [(index, 0), (index, u32::MAX)]);
    let bogus = bogus.map(|(index, generation)| ColliderHandle::from_raw_parts(index, generation));
    // Long enough that colliders are no longer read in the order of the list.
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
fn a_tree_is_kept_while_it_is_asked_for() {
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

        // Nothing has left its margin. The harness's other threads may free a name meanwhile, but not every time.
        let is_steady = (0..8).any(|_| {
            let before = live_bytes();
            for _ in 0..100 {
                desk.update(&balls, &[]);
            }
            query(&desk);
            live_bytes() == before
        });
        assert!(is_steady, "{with_tree} bytes at first");

        // It is kept when boxes change, and takes no more room but for Parry's scratch memory.
        let most = with_tree + 2 * (with_tree - bare);
        for _ in 0..1000 {
            advance_last(&mut desk);
            query(&desk);
            assert!((bare + LEAST..most).contains(&live_bytes()));
        }

        // It is not kept for nobody.
        for _ in 0..100 {
            advance_last(&mut desk);
        }
        assert!(live_bytes() < with_tree - LEAST);
    }
}

/// The kinds of shapes that a world is built of: cuboids, capsules, and both with balls between them.
fn kinds() -> [Vec<SharedShape>; 3] {
    let cuboid = SharedShape::new(rapier::parry::shape::Cuboid::new([0.4; DIM].into()));
    let capsule = SharedShape::capsule_y(0.3, 0.1);
    let ball = SharedShape::ball(0.4);
    let mixed = vec![ball.clone(), cuboid.clone(), ball, capsule.clone()];
    [vec![cuboid], vec![capsule], mixed]
}

/// An update without the checks of a desk, which take memory as well.
fn update_unchecked(desk: &mut Desk, listed: &[ColliderHandle]) {
    let (colliders, bodies) = (&desk.colliders, &desk.bodies);
    let events = &mut Vec::new();
    desk.broad_phase
        .update(&desk.params, colliders, bodies, listed, &[], events);
}

/// How many times lists are reallocated while this many colliders are added that do not meet, in updates of `step` each, and while their
/// broad phase is read from a snapshot.
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

/// Beside balls, which have no half axes, other shapes take one reallocation for each doubling of the number of colliders.
#[test]
fn reallocations_of_volumes_grow_with_the_logarithm_of_colliders() {
    const COUNT: usize = 1 << 12;
    let _turn = turn();
    // And some by the harness's other threads.
    let most = 3 * COUNT.ilog2() as usize;
    let balls = [SharedShape::ball(0.4)];
    for step in [COUNT, 1] {
        let of_balls = reallocated(&balls, COUNT, step);
        for kinds in kinds() {
            let found = reallocated(&kinds, COUNT, step);
            for (found, of_balls) in found.into_iter().zip(of_balls) {
                assert!(found <= of_balls + most, "{found} beside {of_balls}");
            }
        }
    }
}

/// Tall columns sink towards a stack of long bars, and stop before they touch one: each is about to meet all bars.
#[test]
fn memory_does_not_follow_pairs_that_may_never_meet() {
    const COUNT: usize = 3000;
    const STEP: Real = 2.0;
    /// 4 kB a collider, with all that lists take while they grow. The pairs ahead would take four times that.
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
