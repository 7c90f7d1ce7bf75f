//! The suite: one source for every flavour, which the module that includes it names as `rapier`.

use super::{FLAVOUR, Settings, Stats, UnisizeBroadPhase, rapier, version};
use crate::hash::Hash;
use crate::hashes::golden;
use crowd::Crowd;
use oorandom::Rand32;
use rapier::prelude::*;

#[path = "../common/crowd/mod.rs"]
mod crowd;

/// A way in which colliders move about.
struct Replay {
    name: &'static str,
    count: usize,
    /// How far a collider goes in an update at most, along each axis.
    speed: Real,
    /// For every ten updates, the stride: one collider in this many moves.
    strides: &'static [usize],
    /// Whether all turn back after each update.
    is_to_and_fro: bool,
}

/// One replay has enough colliders to be worth several threads.
const ALL: [Replay; 6] = [
    replay("drifting", 1000, 0.05, &[1, 1, 1, 1, 1, 1]),
    replay("fast", 1000, 0.6, &[1, 1, 1, 1]),
    replay("few", 1000, 0.1, &[1, 100, 60, 150, 100, 30]),
    replay("by-turns", 1000, 0.1, &[1, 200, 2, 3, 1, 20, 1, 5]),
    Replay {
        is_to_and_fro: true,
        ..replay("to-and-fro", 1000, 0.02, &[1, 3, 1])
    },
    replay("many", 20_000, 0.1, &[1]),
];

const fn replay(
    name: &'static str,
    count: usize,
    speed: Real,
    strides: &'static [usize],
) -> Replay {
    Replay {
        name,
        count,
        speed,
        strides,
        is_to_and_fro: false,
    }
}

/// What must not matter.
#[derive(Clone, Default)]
struct Way {
    /// Whether clones take each other's place.
    is_cloned: bool,
    /// Whether what was written and read takes its place, before one update in so many.
    saved_every: Option<usize>,
    /// Whether colliders are listed in another order in each update, as the islands of Rapier list them.
    is_shuffled: bool,
    /// Whether each is on a body of its own.
    is_on_bodies: bool,
}

fn write(hash: &mut Hash, events: &[(bool, ColliderPair)]) {
    hash.write(events.len() as u32);
    for &(begins, pair) in events {
        hash.write(u32::from(begins));
        for handle in [pair.collider1, pair.collider2] {
            let (index, generation) = handle.into_raw_parts();
            hash.write(index);
            hash.write(generation);
        }
    }
}

impl Crowd {
    /// Sets the position of the last collider to NaN.
    fn spoil_last(&mut self) {
        self.place(self.handles.len() - 1, [Real::NAN; DIM]);
    }

    /// Gives each collider a body of its own, and leaves it where it is.
    fn put_on_bodies(&mut self) {
        for &handle in &self.handles {
            let place = version::coordinates(&self.colliders[handle]);
            let place = version::vector(place);
            let body = RigidBodyBuilder::dynamic().translation(place);
            let body = self.bodies.insert(body);
            self.colliders
                .set_parent(handle, Some(body), &mut self.bodies);
            self.colliders[handle].set_translation(place);
        }
    }
}

impl Replay {
    /// Checks the hash of all events, and returns the statistics of each update.
    fn check(&self, way: &Way) -> Vec<Stats> {
        // About two to five overlapping pairs per three colliders, without a root of the count.
        let side = match (DIM, self.count) {
            (2, 1000) => 36.0,
            (2, _) => 160.0,
            (_, 1000) => 13.0,
            _ => 36.0,
        };
        let mut crowd = Crowd::new(self.count, side, self.speed);
        // It is refused until it gets a sound position.
        crowd.spoil_last();
        if way.is_on_bodies {
            crowd.put_on_bodies();
        }
        let mut broad_phase = UnisizeBroadPhase::with_settings(Settings::default());
        let mut random = Rand32::new(5);
        let mut hash = Hash::default();
        let (mut events, mut stats) = (0, Vec::new());
        for &stride in self.strides {
            for _ in 0..10 {
                if way.is_cloned {
                    broad_phase = broad_phase.clone();
                }
                if way
                    .saved_every
                    .is_some_and(|every| stats.len() % every == 1)
                {
                    broad_phase = saved(&broad_phase);
                    broad_phase.validate();
                }
                if way.is_shuffled {
                    for i in (1..crowd.modified.len()).rev() {
                        let other = random.rand_range(0..i as u32 + 1) as usize;
                        crowd.modified.swap(i, other);
                    }
                }
                let found = crowd.update(&mut broad_phase);
                write(&mut hash, &found);
                events += found.len();
                stats.push(broad_phase.stats());
                crowd.advance(stride);
                if self.is_to_and_fro {
                    (0..crowd.handles.len()).for_each(|i| crowd.turn_back(i));
                }
            }
        }
        broad_phase.validate();
        assert!(events > self.count, "{}: {events} events", self.name);
        golden(FLAVOUR, self.name, &hash);
        stats
    }
}

/// A broad phase that was written and read.
fn saved(broad_phase: &UnisizeBroadPhase) -> UnisizeBroadPhase {
    #[cfg(feature = "serde-serialize")]
    {
        let bytes = postcard::to_stdvec(broad_phase).expect("it can be written");
        postcard::from_bytes(&bytes).expect("it can be read")
    }
    #[cfg(not(feature = "serde-serialize"))]
    broad_phase.clone()
}

fn check(way: &Way) -> Vec<Vec<Stats>> {
    ALL.iter().map(|replay| replay.check(way)).collect()
}

#[test]
fn replays_are_golden() {
    check(&Way::default());
}

#[test]
fn clones_orders_and_bodies_do_not_matter() {
    for bits in [1, 2, 4, 7] {
        check(&Way {
            is_cloned: bits & 1 > 0,
            is_shuffled: bits & 2 > 0,
            is_on_bodies: bits & 4 > 0,
            ..Way::default()
        });
    }
}

/// Read back, it may search in other updates. The interval divides neither ten nor that between two full searches.
#[test]
fn saves_do_not_matter() {
    check(&Way {
        saved_every: Some(7),
        ..Way::default()
    });
}

/// Even the statistics are the same.
#[test]
fn threads_do_not_matter() {
    let [plain, shuffled] = [false, true].map(|is_shuffled| Way {
        is_shuffled,
        is_on_bodies: is_shuffled,
        ..Way::default()
    });
    let stats = [1, 2, 3, 8, 16].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let pool = pool.expect("there are threads to be had");
        pool.install(|| [check(&plain), check(&shuffled)])
    });
    assert!(stats.iter().all(|other| *other == stats[0]));
}
