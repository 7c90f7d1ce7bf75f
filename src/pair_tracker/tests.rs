//! The tracker against its contract, with enough proxies for both layers, and with numbers of movers on both sides of each threshold
//! between two plans.

use std::collections::BTreeSet;

use oorandom::Rand32;

use super::{Changes, Colliders, FilterKey, PairState, PairTracker};
use crate::aabb::Aabb;
use crate::brute_force::BruteForce;
use crate::volume::{Volume, VolumeKind};

/// Proxies of one side may not meet, except those of side 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Side(pub(crate) u32);

impl FilterKey for Side {
    fn may_meet(self, other: Self) -> bool {
        self.0 != other.0 || self.0 == 0
    }

    fn clique(self) -> Option<u32> {
        (self.0 != 0).then_some(self.0)
    }
}

/// How far the volumes of a held pair may be apart.
const SLACK: f32 = 0.25;

impl Colliders<f32, 2> for Vec<Volume<f32, 2>> {
    fn volume(&self, slot: u32) -> Volume<f32, 2> {
        self[slot as usize]
    }

    fn is_active(&self, _: [u32; 2]) -> bool {
        false
    }
}

/// A tracker, and the sum of its changes.
struct World {
    random: Rand32,
    tracker: PairTracker<f32, 2, Side>,
    /// By slot.
    volumes: Vec<Volume<f32, 2>>,
    held: BTreeSet<[u32; 2]>,
    /// The pairs whose boxes overlapped at the end of the last update, except those that their keys have forbidden ever since they do.
    near_or_held: BTreeSet<[u32; 2]>,
}

impl World {
    fn new(slots: u32, volumes: bool) -> Self {
        let mut tracker = PairTracker::new(volumes);
        tracker.make_room(slots as usize);
        Self {
            random: Rand32::new(u64::from(slots)),
            tracker,
            volumes: vec![Volume::BOX; slots as usize],
            held: BTreeSet::new(),
            near_or_held: BTreeSet::new(),
        }
    }

    /// Moves a slot to a box, with this volume.
    fn place(&mut self, slot: u32, aabb: Aabb<f32, 2>, volume: Volume<f32, 2>) {
        self.set_volume(slot, &aabb, volume);
        self.tracker.proxies.place(slot, aabb);
    }

    /// Gives a slot another volume in its box. The tracker reads that of a capsule or a cuboid only once a pair asks for it.
    fn set_volume(&mut self, slot: u32, aabb: &Aabb<f32, 2>, volume: Volume<f32, 2>) {
        let former = std::mem::replace(&mut self.volumes[slot as usize], volume);
        let has_only_moved = former.kind == volume.kind && volume.kind.axes::<2>() > 0;
        let mut all = self.tracker.proxies.all();
        all.follow_volume(slot as usize, aabb, has_only_moved);
    }

    fn remove(&mut self, slot: u32) {
        self.tracker.remove(slot);
        self.held.retain(|pair| !pair.contains(&slot));
        self.near_or_held.retain(|pair| !pair.contains(&slot));
    }

    /// Makes an update. `validate` checks that the held pairs overlap, and that all are held that may begin. Another pair stays if no box was
    /// renewed, or if the volumes are near enough.
    fn update(&mut self) {
        let (before, boxes) = (self.held.clone(), self.tracker.proxies.previous.clone());
        let mut changes = Changes::new(1);
        self.tracker.update(SLACK, &mut changes, &self.volumes);
        changes.drain(|is_added, pair| {
            let is_due = match is_added {
                true => self.held.insert(pair),
                false => self.held.remove(&pair),
            };
            assert!(is_due, "{pair:?} is repeated");
        });
        assert!(self.tracker.pairs().collect::<BTreeSet<_>>() == self.held);
        self.tracker.validate(&mut BruteForce);
        let proxies = &self.tracker.proxies;
        let are_used = proxies.volumes.are_used;
        let is_renewed = |slot: u32| {
            let [now, before] = [&proxies.boxes, &boxes].map(|b| b[slot as usize]);
            now != before && now.is_valid()
        };
        let meet = |pair: [u32; 2], slack| {
            let [a, b] = pair.map(|slot| self.volumes[slot as usize]);
            !are_used || a.meets(&b, slack)
        };
        for &pair in before.union(&self.held) {
            let may_stay =
                before.contains(&pair) && (!pair.into_iter().any(is_renewed) || meet(pair, SLACK));
            let may_begin = proxies.may_meet(pair) && meet(pair, 0.0);
            let should_be_held = proxies.overlap(pair) && (may_stay || may_begin);
            assert_eq!(self.held.contains(&pair), should_be_held, "{pair:?}");
        }
        let slots = proxies.boxes.len() as u32;
        let all = (0..slots).flat_map(|a| (a + 1..slots).map(move |b| [a, b]));
        let overlapping = all.filter(|&pair| proxies.overlap(pair));
        let is_known = |pair: &_| self.near_or_held.contains(pair) || proxies.may_meet(*pair);
        let known = overlapping.filter(is_known).collect();
        self.near_or_held = known;
        let mut begin = self.near_or_held.difference(&self.held);
        assert!(!begin.any(|&pair| proxies.may_meet(pair) && meet(pair, 0.0)));
        let of_state = |state| self.tracker.candidates.of_state(state);
        let found = of_state(PairState::Near).chain(of_state(PairState::Held));
        assert!(found.collect::<BTreeSet<_>>() == self.near_or_held);
    }

    /// A volume of any kind in a box or near it, at times one that meets all.
    fn random_volume(&mut self, aabb: &Aabb<f32, 2>) -> Volume<f32, 2> {
        let mut near = |x: f32| x + 0.125 * (self.random.rand_float() - 0.5);
        let size = aabb.maxs[0] - aabb.mins[0];
        let center = [0, 1].map(|k| near((aabb.mins[k] + aabb.maxs[k]) / 2.0));
        let half = [near(size) / 3.0, near(0.0)];
        let halves = [half, [-half[1] / 2.0, half[0] / 2.0]];
        match self.random.rand_range(0..12) {
            0 => Volume::BOX,
            1 => Volume::new(VolumeKind::Ball, [f32::NAN; 2], size / 2.0, &[]),
            2 => Volume::new(VolumeKind::HalfSpace, center, 0.0, &[[0.6, 0.8]]),
            3..6 => Volume::new(VolumeKind::Capsule, center, size / 6.0, &halves),
            6..9 => Volume::new(VolumeKind::Cuboid, center, 0.0, &halves),
            _ => Volume::new(VolumeKind::Ball, center, size / 2.0, &[]),
        }
    }

    fn random_box(&mut self, world: f32) -> Aabb<f32, 2> {
        let corner = [(); 2].map(|()| self.random.rand_float() * world);
        // One in fifty is much larger than the rest.
        let is_large = self.random.rand_range(0..50) == 0;
        let size = if is_large { 15.0 } else { 1.0 };
        Aabb::new(corner, corner.map(|x| x + size))
    }

    /// Changes a random slot in a random way.
    fn change(&mut self, slots: u32) {
        let world = (slots as f32 * 2.0).sqrt();
        let slot = self.random.rand_range(0..slots);
        if self.random.rand_range(0..5) == 0 {
            let side = Side(self.random.rand_range(0..3));
            self.tracker.proxies.set_key(slot, side);
        }
        let step = self.random.rand_float() - 0.5;
        let known = self.tracker.proxies.get(slot).copied();
        match (self.random.rand_range(0..10), known) {
            (0, Some(_)) => return self.remove(slot),
            (1, Some(_)) => return self.tracker.proxies.clear_box(slot),
            // Another volume in the same box.
            (2, Some(aabb)) => {
                let volume = self.random_volume(&aabb);
                return self.set_volume(slot, &aabb, volume);
            }
            _ => {}
        }
        let aabb = match (self.random.rand_range(0..4), known) {
            (0, _) | (_, None) => self.random_box(world),
            (_, Some(aabb)) => Aabb::new(aabb.mins.map(|x| x + step), aabb.maxs.map(|x| x + step)),
        };
        let volume = self.random_volume(&aabb);
        self.place(slot, aabb, volume);
    }
}

#[test]
fn random_changes_agree_with_brute_force() {
    for slots in [1, 9, 40, 60, 200, 600] {
        for volumes in [false, true] {
            let mut world = World::new(slots, volumes);
            for update in 0..120 {
                // From none to all, in no order.
                let changes = [0, 1, 3, slots / 20, slots / 8, slots / 5, slots / 4, slots];
                (0..changes[update % 8]).for_each(|_| world.change(slots));
                world.update();
            }
        }
    }
}

/// Nearly all are of one side, at one place, where one of the others passes by now and then.
#[test]
fn a_large_clique_agrees_with_brute_force() {
    const SLOTS: u32 = 200;
    let mut world = World::new(SLOTS, false);
    let mut left_out = 0;
    for update in 0..200 {
        for slot in 0..SLOTS {
            let is_other = slot % 20 == 7;
            let side = Side(if is_other { 2 + slot / 20 % 2 } else { 1 });
            world.tracker.proxies.set_key(slot, side);
            let place = if is_other { 30.0 } else { 4.0 };
            let corner = [(); 2].map(|()| world.random.rand_float() * place);
            let aabb = Aabb::new(corner, corner.map(|x| x + 1.0));
            if is_other || update % 3 == 0 {
                world.tracker.proxies.place(slot, aabb);
            }
        }
        world.update();
        left_out += u32::from(world.tracker.layers.recent().is_none());
    }
    assert!((20..180).contains(&left_out), "{left_out}");
}

/// A ball goes to and fro before another one, in a fat box that reaches it, while their keys forbid the pair.
#[test]
fn a_forbidden_pair_that_has_parted_is_no_neighbor_again() {
    let mut world = World::new(2, true);
    for (x, side) in [(0.97, 0), (0.99, 1), (1.01, 1), (0.99, 1), (0.98, 1)] {
        for (slot, center) in [(0, 0.0), (1, x)] {
            let aabb = Aabb::new([center - 0.5; 2], [center + 0.5; 2]);
            let ball = Volume::new(VolumeKind::Ball, [center; 2], 0.5, &[]);
            world.place(slot, aabb, ball);
            world.tracker.proxies.set_key(slot, Side(side));
        }
        world.update();
    }
    let mut near = world.tracker.candidates.of_state(PairState::Near);
    assert_eq!(near.next(), None);
}

/// Boxes that keep their direction, so that fat boxes are of use. The share of them that moves goes back and forth over each threshold.
#[test]
fn drifting_boxes_agree_with_brute_force() {
    const SLOTS: u32 = 500;
    let side = (SLOTS as f32 / 1.5).sqrt();
    for speed in [0.02, 0.1, 0.6] {
        let mut world = World::new(SLOTS, false);
        let mut random = Rand32::new(9);
        let mut vector = |length: f32| [(); 2].map(|()| (random.rand_float() - 0.5) * length);
        let mut corners: Vec<_> = (0..SLOTS).map(|_| vector(side)).collect();
        let velocities: Vec<_> = (0..SLOTS).map(|_| vector(2.0 * speed)).collect();
        let [mut look_ups, mut partly_cold] = [0; 2];
        for stride in [1, 200, 1, 2, 3, 250, 20, 100, 5, 1, 300] {
            for _ in 0..20 {
                for slot in (0..SLOTS).step_by(stride) {
                    let corner = &mut corners[slot as usize];
                    // One in a hundred is replaced, and one goes and comes back.
                    match world.random.rand_range(0..100) {
                        0 => {
                            world.remove(slot);
                            *corner = corner.map(|x| -x);
                        }
                        1 => world.tracker.proxies.clear_box(slot),
                        _ => {}
                    }
                    for k in 0..2 {
                        corner[k] = (corner[k] + velocities[slot as usize][k]).rem_euclid(side);
                    }
                    let aabb = Aabb::new(*corner, corner.map(|x| x + 1.0));
                    world.tracker.proxies.place(slot, aabb);
                }
                let before = world.tracker.cost.looked_up;
                world.update();
                look_ups += u64::from(world.tracker.cost.looked_up > before);
                let candidates = &world.tracker.candidates;
                let are_partly_cold = (1..candidates.len()).contains(&candidates.first_cold);
                partly_cold += u64::from(are_partly_cold);
            }
        }
        let plans = [world.tracker.full_searches, look_ups, partly_cold];
        assert!(plans.iter().all(|&count| count > 3), "{plans:?}");
    }
}

/// Balls in a checkerboard, whose boxes overlap and that do not touch, and of which only few change.
#[test]
fn a_few_that_change_among_many_at_rest_cost_no_pass_over_all() {
    const SIDE: u32 = 60;
    for changing in [1, 10] {
        let mut world = World::new(SIDE * SIDE, true);
        let ball = |slot: u32, radius: f32| {
            let (x, y) = (slot % SIDE, slot / SIDE);
            let corner = [x, y].map(|i| 0.74 * i as f32);
            let aabb = Aabb::new(corner, corner.map(|x| x + 1.0));
            let center = corner.map(|x| x + 0.5);
            (aabb, Volume::new(VolumeKind::Ball, center, radius, &[]))
        };
        let is_there = |slot: &u32| (slot % SIDE + slot / SIDE) % 2 == 0;
        let slots: Vec<_> = (0..SIDE * SIDE).filter(is_there).collect();
        for &slot in &slots {
            let (aabb, volume) = ball(slot, 0.5);
            world.place(slot, aabb, volume);
        }
        world.update();
        let candidates = &world.tracker.candidates;
        assert!(candidates.len() > 3_000 && world.held.is_empty());
        let listed = slots.iter().copied().skip(500).step_by(97);
        let listed: Vec<_> = listed.take(changing).collect();
        for update in 0..200 {
            let mut neighbors = 0;
            world.tracker.visit_near(&listed, |_| neighbors += 1);
            assert!(neighbors >= 2 * changing);
            for &slot in &listed {
                let (aabb, volume) = ball(slot, if update % 2 == 0 { 0.49 } else { 0.5 });
                world.set_volume(slot, &aabb, volume);
            }
            world.update();
            let looked_at = world.tracker.candidates.first_cold;
            assert!((2 * changing..=8 * changing).contains(&looked_at));
        }
    }
}

/// The fat boxes of resting proxies may be from a time when there was foresight. `tests/memory` has proxies on their way to others.
#[test]
fn candidates_of_resting_proxies_are_not_many_times_as_many_as_proxies() {
    let mut world = World::new(600, false);
    let unit = |corner: [f32; 2]| Aabb::new(corner, corner.map(|x| x + 1.0));
    for slot in 0..600 {
        let corner = [slot % 30, slot / 30].map(|i| 2.0 * i as f32);
        world.tracker.proxies.place(slot, unit(corner));
    }
    world.update();
    while world.tracker.foresight.moves > 0 {
        world.tracker.foresight.shorten();
    }
    world.tracker.proxies.fat_boxes[..100].fill(Aabb::new([-1e3; 2], [1e3; 2]));
    world.tracker.layers.is_base_sorted = false;
    world.tracker.proxies.place(100, unit([500.0, 0.0]));
    world.update();
    assert!(world.tracker.candidates.len() <= 9 * 600);
}
