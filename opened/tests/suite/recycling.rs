//! What Rapier keeps of a contact while the two have hardly moved. It looks at a pair anew only once the two have moved by more than the
//! recycle distance, or, if there is no contact yet, by more than the prediction distance. A pair that begins later than on its own
//! broad phase is looked at when it begins, so a contact may be found some steps earlier; none may be missed.

use super::rapier::prelude::*;
use super::snapshot::contacts;
use super::twins::{Twins, at, cuboid, triple};

/// Bodies that fall into a box, in two worlds of which ours is given the poses and velocities of the other's before each step.
struct Followed {
    twins: Twins,
    bodies: Vec<RigidBodyHandle>,
}

impl Followed {
    fn new(recycle_distance: Real) -> Self {
        let mut twins = Twins::heavy();
        twins.both(|world| {
            world
                .integration_parameters
                .normalized_contact_recycle_distance = recycle_distance;
        });
        twins.insert_floor();
        for side in [-1.0, 1.0] {
            let wall = cuboid([0.5, 20.0, 20.0]).translation(at(4.0 * side, 15.0));
            twins.insert(RigidBodyBuilder::fixed(), wall);
        }
        let mut random = oorandom::Rand32::new(7);
        let mut bodies = Vec::new();
        for i in 0..60 {
            let mut vector = |length: Real| {
                triple(std::array::from_fn(|_| {
                    length * (random.rand_float() - 0.5) as Real
                }))
            };
            let (column, row) = ((i % 5) as Real, (i / 5) as Real);
            let place = at(1.2 * column - 2.4, 1.2 * row + 0.8);
            let body = RigidBodyBuilder::dynamic()
                .translation(place + vector(0.2))
                .linvel(vector(2.0));
            let shape = match i % 3 {
                0 => ColliderBuilder::ball(0.4),
                1 => cuboid([0.3, 0.4, 0.5]),
                _ => ColliderBuilder::capsule_y(0.2, 0.3),
            };
            bodies.push(twins.insert(body, shape).0);
        }
        Self { twins, bodies }
    }

    /// Steps both worlds; returns how many contacts ours has and the other has not, and how many both have.
    fn step(&mut self) -> [usize; 2] {
        let Twins { ours, theirs, .. } = &mut self.twins;
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
        ours.step();
        theirs.step();
        let [ours, theirs] = [&*ours, &*theirs].map(contacts);
        let missing: Vec<_> = theirs.difference(&ours).collect();
        assert!(missing.is_empty(), "only the default has {missing:?}");
        [ours.difference(&theirs).count(), theirs.len()]
    }

    /// What 300 steps add up to.
    fn steps(mut self) -> [usize; 2] {
        let mut sum = [0; 2];
        for _ in 0..300 {
            let found = self.step();
            sum = [0, 1].map(|i| sum[i] + found[i]);
        }
        sum
    }
}

#[test]
fn without_it_contacts_are_the_same_at_every_step() {
    let [early, both] = Followed::new(0.0).steps();
    assert!(both > 10_000, "{both}");
    assert_eq!(early, 0);
}

#[test]
fn with_it_no_contact_is_missing_and_few_are_found_earlier() {
    let [early, both] = Followed::new(0.05).steps();
    println!("{early} contacts found earlier, {both} by both");
    assert!(both > 10_000, "{both}");
    assert!(early * 1_000 < both, "{early} of {both}");
}
