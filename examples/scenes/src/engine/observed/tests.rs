//! What was asked for is kept as it happened, and nothing else is.

use super::super::rapier::prelude::*;
use super::super::space::{Vector, along};
use super::super::version::{BroadPhase, OwnBroadPhase};
use super::super::world::World;
use super::{Observed, PairEvent, Tee, Timing};

/// Balls in a row, of which neighbours overlap.
fn row(count: usize) -> (World, Vec<ColliderHandle>) {
    let mut world = World::new(Vector::default());
    let handles = (0..count).map(|i| {
        let body = RigidBodyBuilder::dynamic().translation(along(0, 1.5 * i as Real));
        let body = world.insert(body, ColliderBuilder::ball(1.0));
        world.bodies[body].colliders()[0]
    });
    let handles = handles.collect();
    (world, handles)
}

/// The number of events that Rapier hears of.
fn update(
    broad_phase: &mut dyn BroadPhase,
    world: &World,
    modified: &[ColliderHandle],
    removed: &[ColliderHandle],
) -> usize {
    let (params, colliders, bodies) = (&world.params, &world.colliders, &world.bodies);
    let mut events = Vec::new();
    broad_phase.update(params, colliders, bodies, modified, removed, &mut events);
    events.len()
}

#[test]
fn what_was_asked_for_is_kept() {
    let (mut world, handles) = row(3);
    let mut all = Observed::new(OwnBroadPhase::new())
        .clocked()
        .with_lists()
        .with_events()
        .with_held();
    assert_eq!(update(&mut all, &world, &handles, &[]), 2);
    assert_eq!(all.held().len(), 2);
    let pair = ColliderPair::new(handles[0], handles[1]);
    assert!(all.holds(pair) && all.holds(pair.swap()));
    let first = all.timing();
    assert_eq!((first.last, first.worst), (first.total, first.total));

    let body = world.colliders[handles[0]].parent();
    world.remove(body.expect("a body"));
    assert_eq!(update(&mut all, &world, &[], &handles[..1]), 0);
    assert_eq!(all.held().len(), 1);

    assert_eq!(all.held_fault(), None);
    assert!(!all.holds(pair));
    let both = all.timing();
    assert_eq!(both.busy_updates, 2);
    assert_eq!(both.last, both.total - first.total);
    assert!(first.end.is_some() && first.end < both.end);
    let updates = all.take_updates();
    assert_eq!(updates.len(), 2);
    assert_eq!(updates[0].modified, handles);
    assert!(updates[0].events.iter().all(|event| event.is_add()));
    assert_eq!(updates[0].events.len(), 2);
    assert_eq!(updates[1].removed, handles[..1]);
    assert!(all.take_updates().is_empty());
}

#[test]
fn nothing_else_is_kept() {
    let (world, handles) = row(3);
    let mut none = Observed::new(OwnBroadPhase::new());
    assert_eq!(update(&mut none, &world, &handles, &[]), 2);
    assert_eq!(none.timing(), Timing::default());
    assert!(none.take_updates().is_empty());

    let mut lists = Observed::new(OwnBroadPhase::new()).with_lists().silent();
    assert_eq!(update(&mut lists, &world, &handles, &[]), 0);
    assert!(lists.take_events().is_empty());
}

#[test]
fn a_contradiction_is_a_fault() {
    let (world, handles) = row(2);
    let mut broad_phase = Observed::new(OwnBroadPhase::new()).with_held();
    update(&mut broad_phase, &world, &handles, &[]);
    assert_eq!(broad_phase.held_fault(), None);
    broad_phase.inner = OwnBroadPhase::new();
    update(&mut broad_phase, &world, &handles, &[]);
    let pair = ColliderPair::new(handles[0], handles[1]);
    assert_eq!(broad_phase.held_fault(), Some(PairEvent::Add(pair)));
}

#[test]
fn events_are_sorted_on_request() {
    let (mut world, handles) = row(20);
    let mut sorted = Observed::new(OwnBroadPhase::new()).with_events().sorted();
    update(&mut sorted, &world, &handles, &[]);
    // Every second ball leaves, so that all pairs end.
    for &handle in handles.iter().step_by(2) {
        let height = 10.0 + 10.0 * handle.into_raw_parts().0 as Real;
        world.colliders[handle].set_translation(along(1, height));
    }
    update(&mut sorted, &world, &handles, &[]);
    let updates = sorted.take_updates();
    for update in &updates {
        assert_eq!(update.events.len(), 19);
        assert!(update.events.is_sorted_by_key(|event| event.sort_key()));
    }
}

#[test]
fn a_tee_gives_both_the_same() {
    let (world, handles) = row(5);
    let new = || Observed::new(OwnBroadPhase::new()).with_lists().with_held();
    let mut tee = Tee::new(new(), new());
    for listed in [&handles[..2], &handles[2..]] {
        let heard = update(&mut tee, &world, listed, &[]);
        let log = tee.heard.take_updates();
        assert_eq!(log, tee.unheard.take_updates());
        assert_eq!(log[0].modified, listed);
        assert_eq!(tee.heard.held(), tee.unheard.held());
        assert!((1..=3).contains(&heard));
    }
    assert_eq!(tee.heard.held().len(), 4);
}
