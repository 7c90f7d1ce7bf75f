//! What a program is asked during a step or a query, and panics at. Who catches that goes on with the same worlds and broad phases.

use std::panic::{AssertUnwindSafe, catch_unwind};

use super::ordered::Ordered;
use super::rapier::prelude::*;
use super::snapshot::EventLog;
use super::twins::{Twins, assert_alike, at, cube, dynamic, fixed};
use super::version;
use super::{PairFilter, Steppable};

/// Where a step panics.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Panics {
    Contact,
    Intersection,
    Solver,
    Event,
}

impl Panics {
    fn at(self, place: Self) {
        assert!(self != place, "{place:?}");
    }
}

impl PhysicsHooks for Panics {
    fn filter_contact_pair(&self, _: &PairFilterContext<'_>) -> Option<SolverFlags> {
        self.at(Self::Contact);
        Some(SolverFlags::default())
    }

    fn filter_intersection_pair(&self, _: &PairFilterContext<'_>) -> bool {
        self.at(Self::Intersection);
        true
    }

    fn modify_solver_contacts(&self, _: &mut ContactModificationContext<'_>) {
        self.at(Self::Solver);
    }
}

impl EventHandler for Panics {
    fn handle_collision_event(
        &self,
        _: &RigidBodySet,
        _: &ColliderSet,
        _: CollisionEvent,
        _: Option<&ContactPair>,
    ) {
        self.at(Self::Event);
    }

    fn handle_contact_force_event(
        &self,
        _: Real,
        _: &RigidBodySet,
        _: &ColliderSet,
        _: &ContactPair,
        _: Real,
    ) {
    }

    version::events_of_soft_bodies!();
}

/// Steps both worlds, up to a panic if there is one; both must look the same. Returns whether there was one.
fn step(worlds: &mut Ordered, place: Option<Panics>) -> bool {
    let logs = [EventLog::default(), EventLog::default()];
    let Twins { ours, theirs, .. } = &mut worlds.twins;
    let ours = catch_unwind(AssertUnwindSafe(|| match &place {
        Some(place) => ours.step(worlds.ours.for_step(), place, place),
        None => ours.step(worlds.ours.for_step(), &(), &logs[0]),
    }));
    let theirs = catch_unwind(AssertUnwindSafe(|| match &place {
        Some(place) => theirs.step(worlds.theirs.for_step(), place, place),
        None => theirs.step(worlds.theirs.for_step(), &(), &logs[1]),
    }));
    assert_eq!(ours.is_err(), theirs.is_err(), "{place:?}");
    worlds.ours.inner.validate();
    let [seen, expected] = worlds.twins.snapshots(logs);
    assert_alike(&seen, &expected);
    ours.is_err()
}

/// Balls and cubes that hop on a floor, through sensors.
fn hopping(filter: PairFilter) -> (Ordered, Vec<RigidBodyHandle>) {
    let mut worlds = Ordered::new(Some(filter));
    let twins = &mut worlds.twins;
    twins.insert_floor();
    let mut bodies = Vec::new();
    for i in 0..12 {
        let x = 2.0 * i as Real;
        let shape = match i % 2 {
            0 => ColliderBuilder::ball(0.5),
            _ => cube(),
        };
        // All have hooks, so that no pairs are left out and all are asked about in one order.
        let hooks = ActiveHooks::all();
        let shape = shape.restitution(0.8).active_hooks(hooks);
        let body = dynamic(x, 0.6 + 0.3 * i as Real);
        bodies.push(twins.insert(body, shape).0);
        let gate = ColliderBuilder::ball(0.3).sensor(true).active_hooks(hooks);
        twins.insert(RigidBodyBuilder::fixed(), gate.translation(at(x, 2.0)));
    }
    (worlds, bodies)
}

/// A step that was broken off has updated the broad phase, and what the rest of it would have done is lost. With debug assertions Rapier
/// 0.36 may find later that its own lists disagree, whatever the broad phase; then the world ends.
#[test]
fn steps_that_panic() {
    for filter in [version::LEVEL_OF_OWN, PairFilter::Shapes] {
        for place in [
            Panics::Contact,
            Panics::Intersection,
            Panics::Solver,
            Panics::Event,
        ] {
            let (mut panics, mut after) = (0, 0);
            for first in [0, 5, 10, 15, 19] {
                let (mut worlds, bodies) = hopping(filter);
                for _ in 0..=first {
                    worlds.step();
                }
                let mut is_broken_off = step(&mut worlds, Some(place));
                panics += usize::from(is_broken_off);
                for round in 0..15 {
                    // What happens between two steps is lost or not, as on Rapier's own.
                    let twins = &mut worlds.twins;
                    let body = bodies[(first + round) % bodies.len()];
                    match round % 3 {
                        0 => twins.change_body(body, |body| body.set_linvel(at(0.0, 3.0), true)),
                        1 => twins.change_body(body, |body| {
                            let place = at(2.0 * (round % 12) as Real - 30.0, 1.0);
                            body.set_translation(place, true);
                        }),
                        _ => {}
                    }
                    let is_over = step(&mut worlds, (round % 5 == 4).then_some(place));
                    if is_over && round % 5 < 4 {
                        break;
                    }
                    after += usize::from(is_broken_off);
                    is_broken_off |= is_over;
                }
            }
            assert!(
                panics > 0 && after > 10,
                "{place:?}: {panics}, {after} steps after one"
            );
        }
    }
}

/// In the first query after a step, which updates a tree, and in later ones.
#[test]
fn queries_that_panic() {
    let mut twins = Twins::heavy();
    twins.insert_floor();
    for i in 0..12 {
        let ball = ColliderBuilder::ball(0.5).restitution(0.8);
        twins.insert(dynamic(2.0 * i as Real, 0.6 + 0.3 * i as Real), ball);
        let gate = ColliderBuilder::ball(0.3).sensor(i % 4 == 0);
        twins.insert(fixed(2.0 * i as Real, 2.0), gate);
    }
    let mut panics = 0;
    for round in 0..40 {
        twins.step();
        for query in 0..3 {
            let height = 0.5 * (round % 8) as Real;
            let ray = Ray::new(at(-5.0, height).into(), at(1.0, 0.0));
            if (round + query) % 2 == 0 {
                let predicate = |_: ColliderHandle, collider: &Collider| {
                    assert!(!collider.is_sensor(), "a predicate");
                    true
                };
                let filter = QueryFilter::new().predicate(&predicate);
                let asked = catch_unwind(AssertUnwindSafe(|| {
                    twins.answers_with(filter, |_, scene| scene.cast_ray(&ray, 100.0, true))
                }));
                panics += usize::from(asked.is_err());
            }
            twins.same(|scene| scene.cast_ray(&ray, 100.0, true));
        }
    }
    assert!(panics > 5, "only {panics} panics");
}
