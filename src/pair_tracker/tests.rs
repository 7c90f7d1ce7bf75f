//! The tracker against brute force, with enough proxies for real layers, and with numbers of movers on both
//! sides of every threshold between full and partial runs.

use std::collections::{BTreeMap, BTreeSet};

use oorandom::Rand32;

use super::{Layers, PairChange, PairTracker};
use crate::Aabb;

/// What the tracker should hold.
#[derive(Default)]
struct Model {
    proxies: BTreeMap<u32, Aabb<f32, 2>>,
    held: BTreeSet<[u32; 2]>,
}

impl Model {
    fn remove(&mut self, slot: u32) {
        self.proxies.remove(&slot);
        self.held.retain(|pair| !pair.contains(&slot));
    }

    /// Returns the pairs added and deleted.
    fn finish(&mut self) -> [BTreeSet<[u32; 2]>; 2] {
        let mut held = BTreeSet::new();
        for (&a, box_a) in &self.proxies {
            for (&b, box_b) in self.proxies.range(a + 1..) {
                if box_a.overlaps(box_b) {
                    held.insert([a, b]);
                }
            }
        }
        let before = std::mem::replace(&mut self.held, held);
        let added = self.held.difference(&before).copied().collect();
        let deleted = before.difference(&self.held).copied().collect();
        [added, deleted]
    }
}

fn random_box(random: &mut Rand32, world: f32) -> Aabb<f32, 2> {
    let corner = [(); 2].map(|()| random.rand_float() * world);
    // One in fifty is much larger than the rest.
    let size = if random.rand_range(0..50) == 0 {
        15.0
    } else {
        1.0
    };
    Aabb::new(corner, corner.map(|x| x + size))
}

fn check(mut layers: Layers<f32, 2>, slots: u32, seed: u64) {
    let mut random = Rand32::new(seed);
    let world = (slots as f32 * 2.0).sqrt();
    let mut tracker = PairTracker::<f32, 2>::default();
    let mut model = Model::default();
    for update in 0..120 {
        // From nothing to everything, in no order.
        let changes = [0, 1, 3, slots / 20, slots / 8, slots / 5, slots / 4, slots][update % 8];
        for _ in 0..changes {
            let slot = random.rand_range(0..slots);
            let known = model.proxies.get(&slot).copied();
            match (random.rand_range(0..10), known) {
                (0, Some(_)) => {
                    tracker.remove(slot);
                    model.remove(slot);
                }
                (1, Some(_)) => {
                    tracker.lift(slot);
                    model.proxies.remove(&slot);
                }
                (2..8, Some(aabb)) => {
                    let step = random.rand_float() - 0.5;
                    let moved = Aabb::new(aabb.mins.map(|x| x + step), aabb.maxs.map(|x| x + step));
                    tracker.place(slot, moved);
                    model.proxies.insert(slot, moved);
                }
                _ => {
                    let aabb = random_box(&mut random, world);
                    tracker.place(slot, aabb);
                    model.proxies.insert(slot, aabb);
                }
            }
        }
        finish_both(&mut tracker, &mut layers, &mut model);
    }
}

/// Finishes the update of both, and compares.
fn finish_both(tracker: &mut PairTracker<f32, 2>, layers: &mut Layers<f32, 2>, model: &mut Model) {
    let [mut added, mut deleted] = model.finish();
    tracker.finish(layers, |change| {
        let is_due = match change {
            PairChange::Added(pair) => added.remove(&pair),
            PairChange::Deleted(pair) => deleted.remove(&pair),
        };
        assert!(is_due, "{change:?} is spurious or repeated");
    });
    assert!(added.is_empty(), "not added: {added:?}");
    assert!(deleted.is_empty(), "not deleted: {deleted:?}");
    assert_eq!(tracker.pair_count(), model.held.len());
    assert!(tracker.pairs().collect::<BTreeSet<_>>() == model.held);
    tracker.validate(&mut Layers::Brute(Default::default()));
}

/// Boxes that keep going where they go, for the reaches to be of use: so many updates with so many movers, then so
/// many with so many others, and so on, to and fro over every threshold.
#[test]
fn drifting_boxes_agree_with_brute_force() {
    const SLOTS: u32 = 500;
    let world = (SLOTS as f32 / 1.5).sqrt();
    for (seed, speed) in [(9, 0.02), (10, 0.1), (11, 0.6)] {
        let mut random = Rand32::new(seed);
        let mut corners = Vec::new();
        let mut velocities = Vec::new();
        for _ in 0..SLOTS {
            corners.push([(); 2].map(|()| random.rand_float() * world));
            velocities.push([(); 2].map(|()| (random.rand_float() - 0.5) * 2.0 * speed));
        }
        let mut tracker = PairTracker::<f32, 2>::default();
        let mut layers = Layers::Grid(Box::default());
        let mut model = Model::default();
        let aabb = |corner: [f32; 2]| Aabb::new(corner, corner.map(|x| x + 1.0));
        let (mut linked, mut watched) = (0, 0);
        for stride in [1, 200, 1, 2, 3, 250, 20, 100, 5, 1, 300] {
            for update in 0..20 {
                for slot in (0..SLOTS).step_by(stride) {
                    let i = slot as usize;
                    // One in a hundred turns, and one is replaced.
                    match random.rand_range(0..100) {
                        0 => velocities[i] = velocities[i].map(|v| -v),
                        1 => {
                            tracker.remove(slot);
                            model.remove(slot);
                            corners[i] = [(); 2].map(|()| random.rand_float() * world);
                        }
                        2 if update % 2 == 0 => {
                            tracker.lift(slot);
                            model.proxies.remove(&slot);
                            continue;
                        }
                        _ => {}
                    }
                    for k in 0..2 {
                        corners[i][k] = (corners[i][k] + velocities[i][k]).rem_euclid(world);
                    }
                    tracker.place(slot, aabb(corners[i]));
                    model.proxies.insert(slot, aabb(corners[i]));
                }
                finish_both(&mut tracker, &mut layers, &mut model);
                linked += usize::from(tracker.candidates.are_linked());
                assert!(tracker.candidates.gone() <= 100 + 2 * tracker.candidate_count());
                watched += usize::from(tracker.candidate_count() > tracker.pair_count());
            }
        }
        assert!(linked > 10, "candidates were linked {linked} times");
        // The last ones are so fast that it hardly pays.
        assert!(watched > 50 || speed > 0.5, "{watched} times");
    }
}

/// A proxy that goes and comes back within an update has not changed.
#[test]
fn proxies_may_be_lifted_and_put_back() {
    for slots in [10, 1000] {
        let mut tracker = PairTracker::<f32, 2>::default();
        let mut layers = Layers::Grid(Box::default());
        let mut model = Model::default();
        for update in 0..4 {
            for slot in (0..slots).step_by(1 + update / 2 * 9) {
                let x = slot as f32 * 0.5;
                let aabb = Aabb::new([x, 0.0], [x + 1.0, 1.0]);
                tracker.lift(slot);
                tracker.place(slot, aabb);
                model.proxies.insert(slot, aabb);
            }
            finish_both(&mut tracker, &mut layers, &mut model);
        }
        assert_eq!(tracker.pair_count(), 2 * slots as usize - 3);
    }
}

/// Huge boxes on their way to small ones would have a candidate with each of them.
#[test]
fn candidates_are_not_many_times_as_many_as_proxies_and_pairs() {
    let mut tracker = PairTracker::<f32, 2>::default();
    let mut layers = Layers::Grid(Box::default());
    let mut model = Model::default();
    let small = |slot: u32| [(slot % 30) as f32 * 2.0, (slot / 30) as f32 * 2.0];
    for update in 0..12 {
        for slot in 0..600 {
            // The first hundred are huge, and come nearer from the left.
            let (corner, size) = if slot < 100 {
                ([5.0 * update as f32 - 300.0, slot as f32 * 0.01], 200.0)
            } else {
                (small(slot - 100), 1.0)
            };
            let aabb = Aabb::new(corner, corner.map(|x| x + size));
            tracker.place(slot, aabb);
            model.proxies.insert(slot, aabb);
        }
        finish_both(&mut tracker, &mut layers, &mut model);
        let most = 9 * (600 + tracker.pair_count());
        assert!(tracker.candidate_count() <= most);
    }
    // Not by those that rest either, whose reaches may be from a time when there was foresight.
    while tracker.horizon.is_any() {
        tracker.horizon.shorten();
    }
    for reach in &mut tracker.reaches[..100] {
        *reach = Aabb::new([-1e3; 2], [1e3; 2]);
    }
    layers.forget();
    tracker.place(100, Aabb::new([500.0, 0.0], [501.0, 1.0]));
    model
        .proxies
        .insert(100, Aabb::new([500.0, 0.0], [501.0, 1.0]));
    finish_both(&mut tracker, &mut layers, &mut model);
    assert!(tracker.candidate_count() <= 9 * (600 + tracker.pair_count()));
}

#[test]
fn layers_agree_with_brute_force() {
    for (slots, seed) in [(1, 1), (9, 2), (40, 3), (200, 4), (600, 5)] {
        check(Layers::Grid(Box::default()), slots, seed);
    }
}

#[test]
fn kernels_without_layers_agree_with_brute_force() {
    check(Layers::Rank(Box::default()), 200, 6);
    check(Layers::Brute(Default::default()), 60, 7);
}

#[test]
fn few_movers_are_looked_up_and_many_are_not() {
    let mut random = Rand32::new(8);
    let mut tracker = PairTracker::<f32, 2>::default();
    let mut layers = Layers::Grid(Box::default());
    for slot in 0..100 {
        tracker.place(slot, random_box(&mut random, 10.0));
    }
    tracker.finish(&mut layers, |_| ());
    assert_eq!(layers.moving(), 0);
    for slot in 0..10 {
        tracker.place(slot, random_box(&mut random, 10.0));
    }
    tracker.finish(&mut layers, |_| ());
    assert_eq!(layers.moving(), 10);
    for slot in 20..80 {
        tracker.place(slot, random_box(&mut random, 10.0));
    }
    tracker.finish(&mut layers, |_| ());
    assert_eq!(layers.moving(), 0);
    // One mover at a time: the moving layer fills up, until a full run is due.
    let mut most = 0;
    for slot in (0..100).cycle().take(300) {
        tracker.place(slot, random_box(&mut random, 10.0));
        tracker.finish(&mut layers, |_| ());
        most = most.max(layers.moving());
    }
    assert!((2..50).contains(&most), "{most} were moving");
}
