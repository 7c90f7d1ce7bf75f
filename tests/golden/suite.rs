//! The suite: one source for every flavour, which the module that includes it names as `rapier`.

use super::rapier;
use super::{Kernel, PairEvent, REPLAYS, Settings, UnisizeBroadPhase};
use crate::hash::Hash;
use crowd::Crowd;
use oorandom::Rand32;
use rapier::math::{DIM, Real};

#[path = "../crowd/mod.rs"]
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
const ALL: [Replay; REPLAYS.len()] = [
    replay("drifting", 1000, 0.05, &[1, 1, 1, 1, 1, 1]),
    replay("fast", 1000, 0.6, &[1, 1, 1, 1]),
    replay("few", 1000, 0.1, &[1, 100, 60, 150, 100, 30]),
    replay("by turns", 1000, 0.1, &[1, 200, 2, 3, 1, 20, 1, 5]),
    Replay {
        is_to_and_fro: true,
        ..replay("to and fro", 1000, 0.02, &[1, 3, 1])
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
    settings: Settings,
    /// Whether clones take each other's place.
    is_cloned: bool,
    /// Whether colliders are listed in another order in each update.
    is_shuffled: bool,
}

/// Whether pairs end before others begin, each by the smaller index and then the larger one, those that begin dealt out in two hands.
fn are_in_order(events: &[PairEvent]) -> bool {
    let key = |event: &PairEvent| {
        let pair = event.pair();
        let index = |handle: rapier::geometry::ColliderHandle| handle.into_raw_parts().0;
        let [first, second] = [pair.collider1, pair.collider2].map(index);
        assert!(first < second);
        (event.is_add(), first, second)
    };
    let keys: Vec<_> = events.iter().map(key).collect();
    let mut sorted = keys.clone();
    sorted.sort_unstable();
    let is_each_once = sorted.is_sorted_by(|a, b| a < b);
    let added = sorted.split_off(sorted.partition_point(|key| !key.0));
    let hands = [0, 1].map(|hand| added.iter().skip(hand).step_by(2));
    sorted.extend(hands.into_iter().flatten());
    is_each_once && keys == sorted
}

fn write(hash: &mut Hash, events: &[PairEvent]) {
    hash.write(events.len() as u32);
    for event in events {
        hash.write(u32::from(event.is_add()));
        let pair = event.pair();
        for handle in [pair.collider1, pair.collider2] {
            let (index, generation) = handle.into_raw_parts();
            hash.write(index);
            hash.write(generation);
        }
    }
}

impl Replay {
    /// The hash of all events.
    fn hash(&self, way: &Way) -> u64 {
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
        let mut broad_phase = UnisizeBroadPhase::with_settings(way.settings);
        let mut random = Rand32::new(5);
        let mut hash = Hash::default();
        let mut events = 0;
        for &stride in self.strides {
            for _ in 0..10 {
                if way.is_cloned {
                    broad_phase = broad_phase.clone();
                }
                if way.is_shuffled {
                    for i in (1..crowd.modified.len()).rev() {
                        let other = random.rand_range(0..i as u32 + 1) as usize;
                        crowd.modified.swap(i, other);
                    }
                }
                let found = crowd.update(&mut broad_phase);
                assert!(are_in_order(&found), "{}: {found:?}", self.name);
                write(&mut hash, &found);
                events += found.len();
                crowd.advance(stride);
                if self.is_to_and_fro {
                    for velocity in &mut crowd.velocities {
                        *velocity = -*velocity;
                    }
                }
            }
        }
        broad_phase.validate();
        assert!(events > self.count, "{}: {events} events", self.name);
        hash.0
    }
}

fn hashes(way: &Way) -> [u64; REPLAYS.len()] {
    ALL.map(|replay| replay.hash(way))
}

fn check<const N: usize>(found: [u64; N], golden: [u64; N]) {
    let table = found.map(|hash| format!("    {hash:#018x},\n")).concat();
    assert!(found == golden, "of {DIM}D:\n{table}");
}

#[test]
fn replays_are_golden() {
    check(hashes(&Way::default()), REPLAYS);
}

#[test]
fn clones_go_on_alike() {
    let way = Way {
        is_cloned: true,
        ..Way::default()
    };
    check(hashes(&way), REPLAYS);
}

#[test]
fn threads_do_not_matter() {
    for threads in 1..=3 {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let pool = pool.expect("there are threads to be had");
        check(pool.install(|| hashes(&Way::default())), REPLAYS);
    }
}

#[test]
fn the_order_of_the_lists_does_not_matter() {
    let way = Way {
        is_shuffled: true,
        ..Way::default()
    };
    check(hashes(&way), REPLAYS);
}

#[test]
fn foresight_and_layers_do_not_matter() {
    let settings = Settings::default();
    for settings in [
        settings.with_foresight(0),
        settings.with_foresight(3),
        settings.with_foresight(64),
        settings.with_layers(false),
    ] {
        let way = Way {
            settings,
            ..Way::default()
        };
        check(hashes(&way), REPLAYS);
    }
}

#[test]
fn kernels_do_not_matter() {
    for kernel in [Kernel::RankSweep, Kernel::BruteForce] {
        let way = Way {
            settings: Settings::default().with_kernel(kernel),
            ..Way::default()
        };
        for (replay, golden) in ALL.iter().zip(REPLAYS) {
            // Brute force takes its time.
            if kernel != Kernel::BruteForce || replay.count <= 1000 {
                let found = replay.hash(&way);
                assert!(
                    found == golden,
                    "{} with {kernel:?}: {found:#x}",
                    replay.name
                );
            }
        }
    }
}

/// Whole simulations, which are the same on every platform only with this feature.
#[cfg(feature = "enhanced-determinism")]
#[test]
fn scenes_are_golden() {
    use super::{Observed, PairFilter, SCENES, Scene};
    use unisize_scenes::SceneKind;

    let hash = |kind| {
        let mut scene = Scene::build(kind, 60, 1);
        // With all pairs, also those that can have no effect.
        let settings = Settings::default().with_filter(PairFilter::Off);
        let broad_phase = UnisizeBroadPhase::with_settings(settings);
        let mut broad_phase = Observed::new(broad_phase).with_events();
        let mut hash = Hash::default();
        for _ in 0..100 {
            scene.step(&mut broad_phase, &(), &());
            write(&mut hash, &broad_phase.take_events());
        }
        hash.0
    };
    check(SceneKind::ALL.map(hash), SCENES);
}
