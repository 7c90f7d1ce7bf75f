//! Many colliders that move, come, go and get NaN positions, with one to three threads: one source for every flavour.

use super::rapier::prelude::*;
use super::{PairEvent, Stats, UnisizeBroadPhase};
use oorandom::Rand32;

/// Enough for every part of the work to be split.
const COUNT: u32 = 20_000;

const UPDATES: usize = 30;

/// The statistics and events of each update of a random world.
fn updates(threads: usize) -> Vec<(Stats, Vec<PairEvent>)> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.expect("there are threads to be had");
    let mut random = Rand32::new(7);
    let side = (f64::from(COUNT) * 2.0).powf(1.0 / DIM as f64) as Real;
    let params = IntegrationParameters::default();
    let mut bodies = RigidBodySet::new();
    let mut colliders = ColliderSet::new();
    let mut broad_phase = UnisizeBroadPhase::new();
    let (mut listed, mut removed) = (Vec::new(), Vec::new());
    let somewhere =
        |random: &mut Rand32| Vector::from_fn(|_, _| random.rand_float() as Real * side);
    let mut velocities = Vec::new();
    for _ in 0..COUNT {
        let place = somewhere(&mut random);
        let collider = ColliderBuilder::ball(0.5).translation(place);
        let body = bodies.insert(RigidBodyBuilder::dynamic());
        listed.push(colliders.insert_with_parent(collider, body, &mut bodies));
        colliders[listed[listed.len() - 1]].set_translation(place);
        velocities.push(Vector::from_fn(|_, _| {
            0.1 * (random.rand_float() as Real - 0.5)
        }));
    }
    // In no order, as the islands of Rapier list them.
    for i in (1..listed.len()).rev() {
        let other = random.rand_range(0..i as u32 + 1) as usize;
        listed.swap(i, other);
    }
    let mut all = Vec::new();
    for update in 0..UPDATES {
        if update % 5 == 4 {
            // In order, as after a first step; new ones last, out of it.
            listed.sort_by_key(|handle| handle.into_raw_parts().0);
            velocities.rotate_left(1);
        }
        let mut events = Vec::new();
        pool.install(|| {
            broad_phase.update(&params, &colliders, &bodies, &listed, &removed, &mut events);
        });
        let events = events.iter().map(PairEvent::from).collect();
        all.push((broad_phase.stats(), events));
        removed.clear();
        for (i, handle) in listed.iter_mut().enumerate() {
            let collider = &mut colliders[*handle];
            let place = collider.translation() + velocities[i];
            match random.rand_range(0..2000) {
                0 => collider.set_translation(Vector::repeat(Real::NAN)),
                1 | 2 => collider.set_translation(somewhere(&mut random)),
                3 => collider.set_enabled(update % 2 == 0),
                5 => {
                    // A new one with an index of its own, which is read among known ones.
                    let collider = ColliderBuilder::ball(0.5).translation(place);
                    *handle = colliders.insert(collider);
                }
                4 => {
                    let parent = collider.parent();
                    let mut islands = IslandManager::new();
                    colliders.remove(*handle, &mut islands, &mut bodies, false);
                    removed.push(*handle);
                    let collider = ColliderBuilder::ball(0.5);
                    *handle = match parent {
                        Some(parent) => colliders.insert_with_parent(collider, parent, &mut bodies),
                        None => colliders.insert(collider),
                    };
                }
                _ => collider.set_translation(place),
            }
        }
    }
    broad_phase.validate();
    assert!(broad_phase.stats().refused > 0 && broad_phase.stats().pairs > 1000);
    all
}

#[test]
fn events_are_the_same_in_the_same_order() {
    let expected = updates(1);
    for threads in [2, 3] {
        for (update, (found, expected)) in updates(threads).iter().zip(&expected).enumerate() {
            assert!(found == expected, "update {update} with {threads} threads");
        }
    }
}
