//! Several worlds at once: they share pipelines, and bodies go from one to another.

use std::mem::swap;

use super::World;
use super::random::Random;
use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, cuboid, dynamic};

/// Worlds with floors on which bodies lie, each in a place of its own.
fn worlds() -> Vec<(Twins, Vec<RigidBodyHandle>)> {
    let worlds = (0..3).map(|world| {
        let mut twins = Twins::heavy();
        twins.insert_floor();
        let bodies = (0..6 + 5 * world).map(|i| {
            // Where no body of another world is.
            let body = dynamic(2.0 * i as Real + 30.0 * world as Real, 0.6);
            match i % 3 {
                0 => twins.insert(body, ColliderBuilder::ball(0.5)).0,
                1 => twins.insert(body, cube()).0,
                _ => {
                    let (body, _) = twins.insert(body, cuboid([0.5, 0.2, 0.5]));
                    twins.insert_part(body, ColliderBuilder::ball(0.3).translation(at(0.0, 0.4)));
                    body
                }
            }
        });
        let bodies = bodies.collect();
        (twins, bodies)
    });
    worlds.collect()
}

/// Exchanges the pipelines of both worlds with those that all share.
fn swap_pipelines(twins: &mut Twins, shared: &mut [World; 2]) {
    let [ours, theirs] = shared;
    for (world, shared) in [(&mut twins.ours, ours), (&mut twins.theirs, theirs)] {
        swap(&mut world.pipeline, &mut shared.pipeline);
        swap(
            &mut world.collision_pipeline,
            &mut shared.collision_pipeline,
        );
    }
}

/// Their buffers outlive a step and know nothing of the world that comes next. In one world, collisions are detected without dynamics.
#[test]
fn one_pipeline_for_several_worlds() {
    let mut random = Random::new(3);
    let mut worlds = worlds();
    let mut shared = [(); 2].map(|()| World::new(at(0.0, 0.0)));
    let mut contacts = [0; 3];
    for _ in 0..240 {
        let chosen = random.below(3);
        let (twins, bodies) = &mut worlds[chosen];
        let (body, velocity) = (random.pick(bodies), random.within(4.0));
        match chosen {
            0 => {
                let collider = twins.ours.bodies[body].colliders()[0];
                let place = at(0.0, random.pick(&[-0.3, 3.0]));
                twins.change(collider, |it| it.set_translation_wrt_parent(place));
            }
            _ => twins.change_body(body, |body| body.set_linvel(velocity, true)),
        }
        swap_pipelines(twins, &mut shared);
        let seen = match chosen {
            0 => twins.collide(),
            _ => twins.step(),
        };
        swap_pipelines(twins, &mut shared);
        contacts[chosen] += seen.contacts.len();
    }
    assert!(contacts.iter().all(|&count| count > 100), "{contacts:?}");
}

/// Inserts copies of a body and its colliders, as they are, in another world.
fn copy(from: &World, to: &mut World, body: RigidBodyHandle) -> RigidBodyHandle {
    let former = &from.bodies[body];
    let copy = to.bodies.insert(former.clone());
    for &collider in former.colliders() {
        let collider = from.colliders[collider].clone();
        to.colliders
            .insert_with_parent(collider, copy, &mut to.bodies);
    }
    copy
}

/// A handle of one world is valid in another, and means another collider there.
#[test]
fn worlds_that_exchange_bodies() {
    let mut random = Random::new(5);
    let mut worlds = worlds();
    let (mut contacts, mut place) = (0, 0.0);
    for _ in 0..120 {
        for (twins, _) in &mut worlds {
            contacts += twins.step().contacts.len();
        }
        let from = random.below(3);
        let to = (from + 1 + random.below(2)) % 3;
        let Ok([(former, bodies), (latter, guests)]) = worlds.get_disjoint_mut([from, to]) else {
            unreachable!("they differ");
        };
        let index = random.below(bodies.len());
        if bodies.len() > 3 {
            let body = bodies.swap_remove(index);
            let guest = copy(&former.ours, &mut latter.ours, body);
            assert_eq!(copy(&former.theirs, &mut latter.theirs, body), guest);
            guests.push(guest);
            former.remove(body);
            // Some arrive where they left, and some elsewhere.
            if random.below(2) == 0 {
                place -= 2.0;
                latter.change_body(guest, |guest| guest.set_translation(at(place, 0.6), true));
            }
        }
    }
    assert!(contacts > 500, "only {contacts} contacts");
}
