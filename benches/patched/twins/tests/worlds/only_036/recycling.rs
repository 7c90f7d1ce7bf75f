//! What Rapier keeps of a contact while the two have hardly moved. It looks at a pair anew only once the two have moved by more than the
//! recycle distance, or, if there is no contact yet, by more than the prediction distance. A pair that begins later than on its own
//! broad phase is looked at when it begins, and from then on at other times. So a contact that is foreseen, of two that are still apart,
//! may be found some steps earlier or later than on its own; of two that touch none may.

use std::collections::BTreeSet;

use super::random::Random;
use super::rapier::parry::query::distance;
use super::rapier::prelude::*;
use super::snapshot::{Pair, contacts, pair};
use super::twins::{Twins, at, cuboid};
use super::{Steppable, World};

/// Bodies that fall into a box, in two worlds of which ours is given the poses and velocities of the other's before each step.
struct Followed {
    twins: Twins,
    bodies: Vec<RigidBodyHandle>,
}

impl Followed {
    fn new(recycle_distance: Real) -> Self {
        let mut twins = Twins::heavy();
        twins.both(|world| {
            world.params.normalized_contact_recycle_distance = recycle_distance;
        });
        twins.insert_floor();
        for side in [-1.0, 1.0] {
            let wall = cuboid([0.5, 20.0, 20.0]).translation(at(4.0 * side, 15.0));
            twins.insert(RigidBodyBuilder::fixed(), wall);
        }
        let mut random = Random::new(7);
        let mut bodies = Vec::new();
        for i in 0..60 {
            let (column, row) = ((i % 5) as Real, (i / 5) as Real);
            let place = at(1.2 * column - 2.4, 1.2 * row + 0.8);
            let body = RigidBodyBuilder::dynamic()
                .translation(place + random.within(0.1))
                .linvel(random.within(1.0));
            let shape = match i % 3 {
                0 => ColliderBuilder::ball(0.4),
                1 => cuboid([0.3, 0.4, 0.5]),
                _ => ColliderBuilder::capsule_y(0.2, 0.3),
            };
            bodies.push(twins.insert(body, shape).0);
        }
        Self { twins, bodies }
    }

    /// Steps both worlds; returns how many contacts ours alone has, the other alone, and how many both have.
    fn step(&mut self) -> [usize; 3] {
        let Twins {
            ours,
            theirs,
            unisize,
            default,
            ..
        } = &mut self.twins;
        for &handle in &self.bodies {
            let body = &theirs.bodies[handle];
            let (pose, linvel, angvel) = (*body.position(), body.linvel(), body.angvel());
            // Both are told, so that both notice the same changes.
            for world in [&mut *ours, &mut *theirs] {
                let body = &mut world.bodies[handle];
                body.set_position(pose, true);
                body.set_linvel(linvel, true);
                body.set_angvel(angvel, true);
            }
        }
        let apart = apart(theirs);
        ours.step(unisize.for_step(), &(), &());
        theirs.step(default.for_step(), &(), &());
        let [ours, theirs] = [ours, theirs].map(|world| contacts(&world.narrow_phase));
        for differing in ours.symmetric_difference(&theirs) {
            assert!(apart.contains(differing), "{differing:?} touch");
        }
        let alone = [ours.difference(&theirs), theirs.difference(&ours)].map(Iterator::count);
        [alone[0], alone[1], ours.intersection(&theirs).count()]
    }

    /// What 300 steps add up to.
    fn steps(mut self) -> [usize; 3] {
        let mut sum = [0; 3];
        for _ in 0..300 {
            let found = self.step();
            sum = [0, 1, 2].map(|i| sum[i] + found[i]);
        }
        sum
    }
}

/// The pairs that the next step will find apart.
fn apart(world: &World) -> BTreeSet<Pair> {
    let place = |collider: &Collider| {
        let body = &world.bodies[collider.parent().expect("all are on bodies")];
        *body.position() * *collider.position_wrt_parent().expect("all are on bodies")
    };
    let all: Vec<_> = world.colliders.iter().collect();
    let mut pairs = BTreeSet::new();
    for (i, (a, first)) in all.iter().enumerate() {
        for (b, second) in &all[i + 1..] {
            let [one, other] = [first, second].map(|collider| place(collider));
            let between = distance(&one, first.shape(), &other, second.shape());
            if between.is_ok_and(|between| between.distance > 0.0) {
                pairs.insert(pair(*a, *b));
            }
        }
    }
    pairs
}

#[test]
fn without_it_contacts_are_the_same_at_every_step() {
    let [early, late, both] = Followed::new(0.0).steps();
    assert!(both > 10_000, "{both}");
    assert_eq!([early, late], [0, 0]);
}

#[test]
fn with_it_no_touch_is_missed_and_few_contacts_are_foreseen_at_other_times() {
    let [early, late, both] = Followed::new(0.05).steps();
    println!("contacts of ours alone {early}, of the default alone {late}, of both {both}");
    assert!(both > 10_000, "{both}");
    assert!((early + late) * 200 < both, "{early} and {late} of {both}");
}
