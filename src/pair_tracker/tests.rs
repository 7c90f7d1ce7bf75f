//! The tracker against brute force, with enough proxies for real layers, and with numbers of movers on both
//! sides of every threshold between full and partial runs.

use std::collections::{BTreeMap, BTreeSet};

use oorandom::Rand32;

use super::{FilterKey, PairChange, PairTracker};
use crate::volume::{Volume, VolumeKind};
use crate::{Aabb, Kernel};

/// Proxies of one side may not meet, except those of side 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Side(u32);

impl FilterKey for Side {
    fn may_meet(self, other: Self) -> bool {
        self.0 != other.0 || self.0 == 0
    }
}

/// What the tracker should hold.
#[derive(Default)]
struct Model {
    proxies: BTreeMap<u32, Aabb<f32, 2>>,
    sides: BTreeMap<u32, Side>,
    held: BTreeSet<[u32; 2]>,
    /// The volumes, if they are in use.
    volumes: Option<BTreeMap<u32, Volume<f32, 2>>>,
    /// The boxes at the end of the last update.
    before: BTreeMap<u32, Aabb<f32, 2>>,
}

/// How far the volumes of a held pair may be apart.
const SLACK: f32 = 0.25;

impl Model {
    fn remove(&mut self, slot: u32) {
        self.proxies.remove(&slot);
        self.before.remove(&slot);
        self.held.retain(|pair| !pair.contains(&slot));
    }

    fn side(&self, slot: u32) -> Side {
        self.sides.get(&slot).copied().unwrap_or_default()
    }

    /// Whether a pair whose boxes overlap is held.
    fn volumes_meet(&self, pair: [u32; 2]) -> bool {
        let Some(volumes) = &self.volumes else {
            return true;
        };
        let [a, b] = pair.map(|slot| volumes.get(&slot).copied().unwrap_or(Volume::BOX));
        let is_renewed = |slot| self.before.get(slot) != self.proxies.get(slot);
        match self.held.contains(&pair) {
            false => a.meets(&b, 0.0),
            true => !pair.iter().any(is_renewed) || a.meets(&b, SLACK),
        }
    }

    /// Returns the pairs added and deleted.
    fn finish(&mut self) -> [BTreeSet<[u32; 2]>; 2] {
        let mut held = BTreeSet::new();
        for (&a, box_a) in &self.proxies {
            for (&b, box_b) in self.proxies.range(a + 1..) {
                if box_a.overlaps(box_b)
                    && self.side(a).may_meet(self.side(b))
                    && self.volumes_meet([a, b])
                {
                    held.insert([a, b]);
                }
            }
        }
        self.before.clone_from(&self.proxies);
        let before = std::mem::replace(&mut self.held, held);
        let added = self.held.difference(&before).copied().collect();
        let deleted = before.difference(&self.held).copied().collect();
        [added, deleted]
    }
}

/// A tracker with room for this number of slots.
fn tracker(kernel: Kernel, slots: u32) -> PairTracker<f32, 2, Side> {
    tracker_with(kernel, slots, false)
}

fn tracker_with(kernel: Kernel, slots: u32, volumes: bool) -> PairTracker<f32, 2, Side> {
    let mut tracker = PairTracker::new(kernel, true, None, volumes);
    tracker.make_room(slots as usize);
    tracker
}

/// A volume in a box, or near it: of every kind, at times one that meets all.
fn random_volume(random: &mut Rand32, aabb: &Aabb<f32, 2>) -> Volume<f32, 2> {
    let mut near = |x: f32| x + 0.125 * (random.rand_float() - 0.5);
    let size = aabb.maxs[0] - aabb.mins[0];
    let center = [0, 1].map(|k| near((aabb.mins[k] + aabb.maxs[k]) / 2.0));
    let half = [near(size) / 3.0, near(0.0)];
    let halves = [half, [-half[1] / 2.0, half[0] / 2.0]];
    match random.rand_range(0..12) {
        0 => Volume::BOX,
        1 => Volume::new(VolumeKind::Ball, [f32::NAN; 2], size / 2.0, &[]),
        2 => Volume::new(VolumeKind::HalfSpace, center, 0.0, &[[0.6, 0.8]]),
        3..6 => Volume::new(VolumeKind::Capsule, center, size / 6.0, &halves),
        6..9 => Volume::new(VolumeKind::Cuboid, center, 0.0, &halves),
        _ => Volume::new(VolumeKind::Ball, center, size / 2.0, &[]),
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

fn check(kernel: Kernel, slots: u32, seed: u64) {
    for volumes in [false, true] {
        check_with(kernel, slots, seed, volumes);
    }
}

fn check_with(kernel: Kernel, slots: u32, seed: u64, volumes: bool) {
    let mut random = Rand32::new(seed);
    let world = (slots as f32 * 2.0).sqrt();
    let mut tracker = tracker_with(kernel, slots, volumes);
    let mut model = Model {
        volumes: volumes.then(BTreeMap::new),
        ..Model::default()
    };
    for update in 0..120 {
        // From nothing to everything, in no order.
        let changes = [0, 1, 3, slots / 20, slots / 8, slots / 5, slots / 4, slots][update % 8];
        for _ in 0..changes {
            let slot = random.rand_range(0..slots);
            let known = model.proxies.get(&slot).copied();
            if random.rand_range(0..5) == 0 {
                let side = Side(random.rand_range(0..3));
                tracker.set_key(slot, side);
                model.sides.insert(slot, side);
            }
            match (random.rand_range(0..10), known) {
                (0, Some(_)) => {
                    tracker.remove(slot);
                    model.remove(slot);
                }
                (1, Some(_)) => {
                    tracker.refuse(slot);
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
            if let (Some(volumes), Some(aabb)) = (&mut model.volumes, model.proxies.get(&slot)) {
                let volume = random_volume(&mut random, aabb);
                tracker.set_volume(slot, &volume, true);
                volumes.insert(slot, volume);
            }
        }
        // Some have another volume in the same box.
        for _ in 0..[0, 2, slots / 2][update % 3] {
            let slot = random.rand_range(0..slots);
            if let (Some(volumes), Some(aabb)) = (&mut model.volumes, model.proxies.get(&slot)) {
                let volume = random_volume(&mut random, aabb);
                tracker.set_volume(slot, &volume, false);
                volumes.insert(slot, volume);
            }
        }
        finish_both(&mut tracker, &mut model);
    }
}

/// Finishes the update of both, and compares.
fn finish_both(tracker: &mut PairTracker<f32, 2, Side>, model: &mut Model) {
    let [mut added, mut deleted] = model.finish();
    tracker.finish(SLACK, |change| {
        let is_due = match change {
            PairChange::Added(pair) => added.remove(&pair),
            PairChange::Deleted(pair) => deleted.remove(&pair),
        };
        assert!(is_due, "{change:?} is spurious or repeated");
    });
    assert!(added.is_empty(), "not added: {added:?}");
    assert!(deleted.is_empty(), "not deleted: {deleted:?}");
    assert_eq!(tracker.candidates.held_count(), model.held.len());
    assert!(tracker.pairs().collect::<BTreeSet<_>>() == model.held);
    tracker.validate(Kernel::BruteForce);
}

/// Boxes that keep going in one direction, so that fat boxes are of use: some updates with some movers, then
/// with others, and so on, back and forth over every threshold.
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
        let mut tracker = tracker(Kernel::GridSweep, SLOTS);
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
                            tracker.refuse(slot);
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
                finish_both(&mut tracker, &mut model);
                linked += usize::from(tracker.candidates.lists().are_made);
                assert!(tracker.candidates.tombstones() <= 100 + 2 * tracker.candidates.len());
                watched += usize::from(tracker.candidates.len() > tracker.candidates.held_count());
            }
        }
        assert!(linked > 10, "candidates were linked {linked} times");
        // The last ones are so fast that it hardly pays.
        assert!(watched > 50 || speed > 0.5, "{watched} times");
    }
}

/// A proxy that goes and comes back within an update has not changed.
#[test]
fn proxies_may_be_refused_and_put_back() {
    for slots in [10, 1000] {
        let mut tracker = tracker(Kernel::GridSweep, slots);
        let mut model = Model::default();
        for update in 0..4 {
            for slot in (0..slots).step_by(1 + update / 2 * 9) {
                let x = slot as f32 * 0.5;
                let aabb = Aabb::new([x, 0.0], [x + 1.0, 1.0]);
                tracker.refuse(slot);
                tracker.place(slot, aabb);
                model.proxies.insert(slot, aabb);
            }
            finish_both(&mut tracker, &mut model);
        }
        assert_eq!(tracker.candidates.held_count(), 2 * slots as usize - 3);
    }
}

/// Huge boxes on their way to small ones would have a candidate with each of them.
#[test]
fn candidates_are_not_many_times_as_many_as_proxies_and_pairs() {
    let mut tracker = tracker(Kernel::GridSweep, 600);
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
        finish_both(&mut tracker, &mut model);
        let most = 9 * (600 + tracker.candidates.held_count());
        assert!(tracker.candidates.len() <= most);
    }
    // Not by those that rest either, whose fat boxes may be from a time when there was foresight.
    while tracker.foresight.is_any() {
        tracker.foresight.shorten();
    }
    for fat in &mut tracker.fat_boxes[..100] {
        *fat = Aabb::new([-1e3; 2], [1e3; 2]);
    }
    tracker.layers.forget();
    tracker.place(100, Aabb::new([500.0, 0.0], [501.0, 1.0]));
    model
        .proxies
        .insert(100, Aabb::new([500.0, 0.0], [501.0, 1.0]));
    finish_both(&mut tracker, &mut model);
    assert!(tracker.candidates.len() <= 9 * (600 + tracker.candidates.held_count()));
}

#[test]
fn layers_agree_with_brute_force() {
    for (slots, seed) in [(1, 1), (9, 2), (40, 3), (200, 4), (600, 5)] {
        check(Kernel::GridSweep, slots, seed);
    }
}

#[test]
fn kernels_without_layers_agree_with_brute_force() {
    check(Kernel::RankSweep, 200, 6);
    check(Kernel::BruteForce, 60, 7);
}

#[test]
fn few_movers_are_looked_up_and_many_are_not() {
    let mut random = Rand32::new(8);
    let mut tracker = tracker(Kernel::GridSweep, 100);
    for slot in 0..100 {
        tracker.place(slot, random_box(&mut random, 10.0));
    }
    tracker.finish(0.0, |_| ());
    assert_eq!(tracker.layers.slots_above_base(), 0);
    for slot in 0..10 {
        tracker.place(slot, random_box(&mut random, 10.0));
    }
    tracker.finish(0.0, |_| ());
    assert_eq!(tracker.layers.slots_above_base(), 10);
    for slot in 20..80 {
        tracker.place(slot, random_box(&mut random, 10.0));
    }
    tracker.finish(0.0, |_| ());
    assert_eq!(tracker.layers.slots_above_base(), 0);
    // One mover at a time: the delta layer fills up, until a full run is due.
    let mut most = 0;
    for slot in (0..100).cycle().take(300) {
        tracker.place(slot, random_box(&mut random, 10.0));
        tracker.finish(0.0, |_| ());
        most = most.max(tracker.layers.slots_above_base());
    }
    assert!((2..50).contains(&most), "{most} were above the base");
}

#[test]
fn a_pair_begins_and_ends_with_what_allows_it() {
    let mut tracker = tracker(Kernel::GridSweep, 3);
    let mut model = Model::default();
    for slot in 0..3 {
        let aabb = Aabb::new([slot as f32 * 0.6, 0.0], [slot as f32 * 0.6 + 1.0, 1.0]);
        tracker.place(slot, aabb);
        model.proxies.insert(slot, aabb);
    }
    finish_both(&mut tracker, &mut model);
    let mut set = |sides: &[(u32, u32)]| {
        for &(slot, side) in sides {
            tracker.set_key(slot, Side(side));
            model.sides.insert(slot, Side(side));
        }
        finish_both(&mut tracker, &mut model);
        tracker.candidates.len()
    };
    assert_eq!(set(&[]), 2);
    assert_eq!(set(&[(0, 1), (1, 1)]), 1);
    assert_eq!(set(&[(2, 1)]), 0);
    assert_eq!(set(&[(1, 2)]), 2);
    // There and back again, and by a detour: the first of the keys is the one that counts.
    assert_eq!(set(&[(1, 1), (1, 2)]), 2);
    assert_eq!(set(&[(1, 2), (1, 0), (1, 1)]), 0);
    assert_eq!(set(&[(1, 0), (1, 2), (1, 0)]), 2);
}
