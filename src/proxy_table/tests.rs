//! The table against a model, by random sequences, from both sources of boxes and in every order of reading.

use std::collections::{BTreeMap, BTreeSet};

use oorandom::Rand32;

use super::{BoxSource, FilterKey, Handle, ProxyTable};
use crate::tuning::update::{READ_AS_LISTED_UP_TO, THREADS_FROM};
use crate::{Aabb, GridSweep, Kernel, PairFinder, Settings, Stats};

const MARGIN: f32 = 0.125;

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Id {
    slot: u32,
    generation: u32,
}

impl Handle for Id {
    fn from_raw_parts(slot: u32, generation: u32) -> Self {
        Self { slot, generation }
    }

    fn into_raw_parts(self) -> (u32, u32) {
        (self.slot, self.generation)
    }
}

/// Proxies of one side may not meet, except those of side 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Side(u32);

impl FilterKey for Side {
    fn may_meet(self, other: Self) -> bool {
        self.0 != other.0 || self.0 == 0
    }
}

/// The engine's colliders, by slot.
#[derive(Clone, Default)]
struct Colliders {
    slots: Vec<Collider>,
}

#[derive(Clone, Copy)]
struct Collider {
    generation: u32,
    aabb: Aabb<f32, 2>,
    side: Side,
    exists: bool,
    is_enabled: bool,
}

impl Colliders {
    fn get(&self, id: Id) -> Option<&Collider> {
        let collider = self.slots.get(id.slot as usize)?;
        (collider.exists && collider.generation == id.generation).then_some(collider)
    }

    fn id(&self, slot: u32) -> Id {
        Id {
            slot,
            generation: self.slots[slot as usize].generation,
        }
    }
}

/// What is remembered is whose memory it is: it must never be that of another collider.
#[derive(Clone, Default)]
struct Memo {
    owner: Option<Id>,
}

impl BoxSource<f32, 2> for Colliders {
    type Handle = Id;
    type Memo = Memo;
    type Key = Side;

    fn has_keys(&self) -> bool {
        true
    }

    fn read(&self, id: Id, memo: &mut Memo) -> Option<(Aabb<f32, 2>, Side)> {
        assert!(
            memo.owner.is_none_or(|owner| owner == id),
            "the memo of another collider"
        );
        let collider = self.get(id)?;
        memo.owner = Some(id);
        collider
            .is_enabled
            .then_some((collider.aabb, collider.side))
    }
}

/// What the table should hold.
#[derive(Default)]
struct Model {
    /// Colliders that are known, and the boxes of those that are not refused.
    known: BTreeMap<u32, (u32, Option<Aabb<f32, 2>>)>,
    sides: BTreeMap<u32, Side>,
    held: BTreeSet<[u32; 2]>,
    /// What the next update has to look for, with the boxes that were handed over.
    awaited: Vec<(Id, Option<Aabb<f32, 2>>)>,
    moved: usize,
}

impl Model {
    fn remove(&mut self, id: Id) {
        if self
            .known
            .get(&id.slot)
            .is_some_and(|known| known.0 == id.generation)
        {
            self.known.remove(&id.slot);
            self.held.retain(|pair| !pair.contains(&id.slot));
        }
    }

    /// A known collider keeps its side.
    fn hand_over(&mut self, id: Id, aabb: Aabb<f32, 2>) {
        match self.known.get_mut(&id.slot) {
            Some(known) if known.0 == id.generation => {
                let side = self.sides[&id.slot];
                return self.read(id, Some((aabb, side)));
            }
            Some((generation, held)) => {
                // Queries find the box in its slot. If that is wrong, the next update puts it right.
                let outdated = Id {
                    generation: *generation,
                    ..id
                };
                self.awaited.push((outdated, None));
                if aabb.is_valid() {
                    *held = Some(aabb);
                }
            }
            None => {}
        }
        self.awaited.push((id, Some(aabb)));
    }

    fn update(&mut self, modified: &[Id], removed: &[Id], colliders: &Colliders) {
        let read = |id| {
            let collider = colliders.get(id).filter(|collider| collider.is_enabled);
            collider.map(|collider| (collider.aabb, collider.side))
        };
        removed.iter().for_each(|&id| self.remove(id));
        for (id, aabb) in std::mem::take(&mut self.awaited) {
            if !removed.contains(&id) {
                let found = read(id).map(|(found, side)| (aabb.unwrap_or(found), side));
                self.read(id, found);
            }
        }
        modified.iter().for_each(|&id| self.read(id, read(id)));
    }

    fn read(&mut self, id: Id, found: Option<(Aabb<f32, 2>, Side)>) {
        let Some((aabb, side)) = found else {
            return self.remove(id);
        };
        if let Some(&(generation, _)) = self.known.get(&id.slot) {
            if generation != id.generation {
                self.remove(Id { generation, ..id });
            }
        }
        self.sides.insert(id.slot, side);
        let held = &mut self.known.entry(id.slot).or_insert((id.generation, None)).1;
        let renewed = match held {
            Some(held) if aabb.is_valid() && held.contains(&aabb) => return,
            Some(_) if aabb.is_valid() => Some(aabb.loosened(MARGIN)),
            None if !aabb.is_valid() => return,
            _ => aabb.is_valid().then_some(aabb),
        };
        *held = renewed;
        self.moved += 1;
    }

    /// The pairs that are added and deleted.
    fn finish(&mut self) -> [BTreeSet<[u32; 2]>; 2] {
        let boxes = self
            .known
            .iter()
            .filter_map(|(&slot, known)| Some((slot, known.1?)));
        let (slots, boxes): (Vec<_>, Vec<_>) = boxes.unzip();
        let mut pairs = Vec::new();
        // Which the oracle's tests hold to the oracle.
        GridSweep::default().find_pairs(&boxes, &mut pairs).unwrap();
        let held = pairs.iter().map(|pair| pair.map(|i| slots[i as usize]));
        let held = held.filter(|pair| {
            let [a, b] = pair.map(|slot| self.sides[&slot]);
            a.may_meet(b)
        });
        let before = std::mem::replace(&mut self.held, held.collect());
        let added = self.held.difference(&before).copied().collect();
        let deleted = before.difference(&self.held).copied().collect();
        [added, deleted]
    }
}

struct World {
    random: Rand32,
    side: f32,
    colliders: Colliders,
    table: ProxyTable<f32, 2, Memo, Side>,
    model: Model,
}

impl World {
    fn new(slots: u32, seed: u64) -> Self {
        Self {
            random: Rand32::new(seed),
            side: (slots as f32 * 1.5).sqrt(),
            colliders: Colliders::default(),
            table: ProxyTable::new(&Settings::default()),
            model: Model::default(),
        }
    }

    fn random_box(&mut self) -> Aabb<f32, 2> {
        let corner = [(); 2].map(|()| self.random.rand_float() * self.side);
        Aabb::new(corner, corner.map(|x| x + 1.0))
    }

    /// Changes the collider of a slot in some way, and says what is to be listed as modified and as removed.
    fn change(&mut self, slot: u32, modified: &mut Vec<Id>, removed: &mut Vec<Id>) {
        let id = self.colliders.id(slot);
        let anywhere = self.random_box();
        let choice = self.random.rand_range(0..100);
        let step = (self.random.rand_float() - 0.5) * 0.5;
        let collider = &mut self.colliders.slots[slot as usize];
        match choice {
            // It is gone, and another one may have its slot; what was listed before may come after that.
            0..6 if collider.exists => {
                collider.exists = false;
                match choice {
                    0 => removed.push(id),
                    1 => modified.push(id),
                    2 => removed.extend([id, id]),
                    _ => {
                        collider.exists = true;
                        collider.generation += 1;
                        collider.aabb = anywhere;
                        collider.is_enabled = true;
                        let newer = Id {
                            generation: id.generation + 1,
                            ..id
                        };
                        match choice {
                            3 => removed.push(id),
                            4 => modified.push(id),
                            _ => {}
                        }
                        modified.push(newer);
                        modified.extend((choice == 5).then_some(id));
                    }
                }
            }
            _ if !collider.exists => {
                collider.exists = true;
                collider.generation += 1;
                collider.aabb = anywhere;
                collider.is_enabled = true;
                modified.push(self.colliders.id(slot));
            }
            6..9 => {
                collider.is_enabled = !collider.is_enabled;
                modified.push(id);
                removed.extend((choice == 6 && !collider.is_enabled).then_some(id));
            }
            9 | 10 => {
                collider.aabb.mins[1] = f32::NAN;
                modified.push(id);
            }
            11 | 12 => {
                collider.aabb = anywhere;
                modified.extend([id, id]);
            }
            14..18 => {
                collider.side = Side(choice % 3);
                modified.push(id);
            }
            13 => modified.push(Id {
                generation: id.generation + 7,
                ..id
            }),
            _ => {
                for k in 0..2 {
                    collider.aabb.mins[k] += step;
                    collider.aabb.maxs[k] += step;
                }
                modified.push(id);
            }
        }
    }

    /// Hands boxes over to both.
    fn hand_over(&mut self, boxes: &[(Id, Aabb<f32, 2>)]) {
        let before = self.table.stats();
        self.table.hand_over(boxes.iter().copied(), MARGIN);
        for &(id, aabb) in boxes {
            self.model.hand_over(id, aabb);
        }
        let after = self.table.stats();
        // What the last update did stays.
        let before = Stats {
            proxies: after.proxies,
            refused: after.refused,
            ..before
        };
        assert_eq!(after, before);
        for (slot, known) in &self.model.known {
            let aabb = self.table.tracker.get(*slot);
            assert_eq!(aabb, known.1.as_ref());
        }
        self.table.validate(Kernel::GridSweep);
    }

    /// One update of both.
    fn update(&mut self, modified: &[Id], removed: &[Id]) {
        self.table
            .update([modified, removed], &self.colliders, MARGIN);
        self.model.update(modified, removed, &self.colliders);

        let [mut added, mut deleted] = self.model.finish();
        let counts = [added.len(), deleted.len()];
        let mut events: Vec<(bool, [Id; 2])> = Vec::new();
        self.table
            .finish(&mut Vec::new(), &mut events, |is_added, pair| {
                (is_added, pair)
            });
        for (is_added, pair) in events {
            let due = if is_added { &mut added } else { &mut deleted };
            for id in pair {
                let known = self.model.known.get(&id.slot);
                assert!(
                    known.is_some_and(|known| known.0 == id.generation),
                    "{id:?}"
                );
            }
            assert!(due.remove(&pair.map(|id| id.slot)), "{pair:?} is spurious");
        }
        assert!(added.is_empty(), "not added: {added:?}");
        assert!(deleted.is_empty(), "not deleted: {deleted:?}");

        let stats = self.table.stats();
        assert_eq!(stats.moved, std::mem::take(&mut self.model.moved));
        let proxies = self
            .model
            .known
            .values()
            .filter(|known| known.1.is_some())
            .count();
        assert_eq!([stats.added, stats.deleted], counts);
        assert_eq!(stats.proxies, proxies);
        assert_eq!(stats.refused, self.model.known.len() - proxies);
        assert_eq!(stats.pairs, self.model.held.len());
        assert!(self.table.pairs().collect::<BTreeSet<_>>() == self.model.held);
        for (slot, aabb) in self.table.tracker.proxies() {
            assert_eq!(self.model.known[&slot].1.as_ref(), Some(aabb));
        }
        self.table.validate(Kernel::GridSweep);
    }

    /// The box of the collider, or some other one.
    fn box_to_hand_over(&mut self, id: Id) -> Aabb<f32, 2> {
        let anywhere = self.random_box();
        match self.random.rand_range(0..16) {
            0 => Aabb::new(anywhere.maxs, anywhere.mins),
            1 => anywhere,
            _ => self
                .colliders
                .get(id)
                .map_or(anywhere, |collider| collider.aabb),
        }
    }

    /// Lists in no order, or ascending.
    fn arrange(&mut self, ids: &mut [Id], is_sorted: bool) {
        if is_sorted {
            ids.sort();
        } else {
            for i in (1..ids.len()).rev() {
                ids.swap(i, self.random.rand_range(0..i as u32 + 1) as usize);
            }
        }
    }
}

fn check(slots: u32, updates: usize, seed: u64) {
    let mut world = World::new(slots, seed);
    for _ in 0..slots {
        let aabb = world.random_box();
        world.colliders.slots.push(Collider {
            generation: 0,
            aabb,
            side: Side::default(),
            exists: true,
            is_enabled: true,
        });
    }
    let all: Vec<_> = (0..slots).map(|slot| world.colliders.id(slot)).collect();
    // No collider is known yet.
    let boxes = all
        .iter()
        .map(|&id| (id, world.colliders.get(id).unwrap().aabb));
    let boxes: Vec<_> = boxes.take(slots as usize / 2).collect();
    world.hand_over(&boxes);
    world.update(&all[slots as usize / 3..], &[]);
    for update in 0..updates {
        let [mut modified, mut removed] = [vec![], vec![]];
        let stride = [1, 1, 7, 3, 40][update % 5];
        for slot in (0..slots).step_by(stride) {
            world.change(slot, &mut modified, &mut removed);
        }
        world.arrange(&mut modified, update % 3 == 0);
        if update % 2 == 0 {
            // Known ones, new ones, and such as never existed or are gone; most of them once, some are listed as well.
            let from = modified.len() / 2;
            let handed_over: Vec<_> = modified[from..]
                .iter()
                .map(|&id| (id, world.box_to_hand_over(id)))
                .collect();
            modified.truncate(from + from / 4);
            let (first, second) = handed_over.split_at(handed_over.len() / 3);
            world.hand_over(first);
            world.table = world.table.clone();
            world.hand_over(second);
            world.hand_over(&second[..second.len() / 4]);
            let nowhere = Id {
                slot: u32::MAX - update as u32,
                generation: 0,
            };
            let anywhere = world.random_box();
            world.hand_over(&[(nowhere, anywhere)]);
        }
        world.update(&modified, &removed);
    }
    // Nothing of it is left over.
    world.update(&[], &[]);
}

#[test]
fn colliders_read_as_listed_agree_with_the_model() {
    for (slots, seed) in [(1, 1), (8, 2), (READ_AS_LISTED_UP_TO as u32 / 2, 3)] {
        check(slots, 200, seed);
    }
}

#[test]
fn colliders_read_by_index_agree_with_the_model() {
    check(4 * READ_AS_LISTED_UP_TO as u32, 60, 4);
}

#[test]
fn colliders_read_in_parts_agree_with_the_model() {
    check(THREADS_FROM as u32 * 5 / 4, 10, 5);
}

#[test]
fn moved_colliders_are_counted_once() {
    let mut world = World::new(4, 6);
    let aabb = Aabb::new([0.0; 2], [1.0; 2]);
    let collider = Collider {
        generation: 0,
        aabb,
        side: Side::default(),
        exists: true,
        is_enabled: true,
    };
    world.colliders.slots.push(collider);
    let id = world.colliders.id(0);
    world.hand_over(&[(id, aabb)]);
    world.update(&[id, id], &[]);
    let stats = world.table.stats();
    assert_eq!(
        [stats.updates as usize, stats.listed, stats.moved],
        [1, 3, 1]
    );
    world.update(&[id], &[]);
    let stats = world.table.stats();
    assert_eq!(
        [stats.updates as usize, stats.listed, stats.moved],
        [2, 1, 0]
    );
}
