//! Cases that tests of whole broad phases do not reach: long lists in any order, and unusual slots.

use oorandom::Rand32;

use super::passing::Id;
use super::{Changes, ColliderSource, Handle, Lists, ProxyTable, Reading};
use crate::aabb::Aabb;
use crate::pair_filter::PairFilter;
use crate::pair_tracker::Side;
use crate::parallel::with_threads;
use crate::tuning::update::{MOST_NOTES_A_SLOT, ROOM_AHEAD};
use crate::volume::{Volume, VolumeKind};

const MARGIN: f32 = 0.125;

impl Handle for Id {
    fn from_raw_parts(slot: u32, generation: u32) -> Self {
        (slot, generation)
    }

    fn into_raw_parts(self) -> (u32, u32) {
        self
    }
}

/// The engine's colliders, by slot: the generation, and the collider if there is one.
type Colliders = Vec<(u32, Option<Collider>)>;

type Collider = (Aabb<f32, 2>, Side);

/// The memo of a collider is its own name: the table must never pass that of another one.
type Memo = Option<Id>;

impl ColliderSource<f32, 2> for Colliders {
    type Handle = Id;
    type Memo = Memo;
    type Key = Side;

    fn reach(&self) -> f32 {
        0.0
    }

    fn has_changed_unmoved(&self, _: Id, _: &Memo, _: &Side) -> bool {
        true
    }

    fn read(&self, id: Id, memo: &mut Memo) -> Option<Reading<f32, 2, Side>> {
        let has_only_moved = memo.is_some();
        assert_eq!(*memo.get_or_insert(id), id, "the memo of another collider");
        let &(generation, collider) = self.get(id.0 as usize)?;
        let (aabb, key) = collider.filter(|_| generation == id.1)?;
        Some(Reading {
            aabb,
            key,
            has_only_moved,
            is_skipped: false,
        })
    }

    /// A volume whose kind depends on the slot and the generation.
    fn volume(&self, id: Id, memo: &Memo, _: f32) -> Volume<f32, 2> {
        assert_eq!(*memo, Some(id));
        let (generation, collider) = self[id.0 as usize];
        let Some((aabb, _)) = collider.filter(|_| generation == id.1) else {
            return Volume::BOX;
        };
        let center = [0, 1].map(|k| (aabb.mins[k] + aabb.maxs[k]) / 2.0);
        let halves = [[0.25, 0.125], [-0.125, 0.25]];
        match (id.0 + id.1) % 5 {
            0 => Volume::new(VolumeKind::Capsule, center, 0.25, &halves[..1]),
            1 => Volume::new(VolumeKind::Cuboid, center, 0.125, &halves),
            2 => Volume::BOX,
            3 => Volume {
                kind: VolumeKind::BoxUntilRead,
                ..Volume::BOX
            },
            _ => Volume::new(VolumeKind::Ball, center, 0.5, &[]),
        }
    }
}

type Table = ProxyTable<f32, 2, Memo, Side>;

fn table(filter: PairFilter) -> Table {
    Table::new(filter == PairFilter::Shapes)
}

fn finish(table: &mut Table, source: &Colliders) -> Vec<(bool, [Id; 2])> {
    let mut events = Vec::new();
    let changes = &mut Changes::new(1);
    table.finish(source, 2.0 * MARGIN, None, changes, |is_added, ids| {
        events.push((is_added, ids));
    });
    table.validate();
    events
}

/// Changes a collider at random. Returns whether it has only moved.
fn change(random: &mut Rand32, colliders: &mut Colliders, slot: u32, side: f32) -> bool {
    let anywhere = [(); 2].map(|()| random.rand_float() * side);
    let anywhere = Aabb::new(anywhere, anywhere.map(|x| x + 1.0));
    let step = (random.rand_float() - 0.5) * 0.5;
    let choice = random.rand_range(0..40);
    let (generation, collider) = &mut colliders[slot as usize];
    let was_there = collider.is_some();
    match (choice, &mut *collider) {
        (_, None) | (0, _) => {
            *generation += choice % 2;
            *collider = Some((anywhere, Side(slot)));
        }
        (1, _) => *collider = None,
        (2, Some((_, key))) => *key = Side(key.0 % 3),
        (3, Some((aabb, _))) => aabb.mins[1] = f32::NAN,
        (4, Some((aabb, _))) => *aabb = anywhere,
        (_, Some((aabb, _))) => {
            *aabb = Aabb::new(aabb.mins.map(|x| x + step), aabb.maxs.map(|x| x + step));
        }
    }
    was_there && choice > 2
}

/// Lists of colliders whose boxes stay.
fn in_place_of(handles: &[Id]) -> Lists<'_, Id> {
    let (unmoved, swept) = handles.split_at(handles.len() / 2);
    Lists {
        unmoved,
        swept,
        ..Lists::new(&[], &[])
    }
}

/// Gives one table all changes at once, in random order and some of them as boxes; gives another table a few at a time.
fn check(filter: PairFilter, slots: u32, updates: usize) {
    let mut random = Rand32::new(u64::from(slots));
    let mut colliders = vec![(0, None); slots as usize];
    let side = (slots as f32 * 1.5).sqrt();
    let [mut at_once, mut by_and_by] = [(); 2].map(|()| table(filter));
    for update in 0..updates {
        let [mut modified, mut removed] = [vec![], vec![]];
        let mut boxes = Vec::new();
        for slot in (0..slots).step_by([1, 1, 7, 3, 40][update % 5]) {
            let former = (slot, colliders[slot as usize].0);
            let is_moved = change(&mut random, &mut colliders, slot, side);
            let (generation, collider) = colliders[slot as usize];
            let id = (slot, generation);
            if is_moved && update % 2 == 1 && slot % 4 > 0 {
                boxes.push((id, collider.unwrap().0));
            } else {
                // Most lists omit a collider, or name one twice.
                modified.extend([id, former].into_iter().take(1 + slot as usize % 2));
                if id != former && slot % 3 > 0 {
                    removed.push(former);
                }
            }
        }
        if update % 3 > 0 {
            for i in (1..modified.len()).rev() {
                modified.swap(i, random.rand_range(0..i as u32 + 1) as usize);
            }
        }
        at_once.set_boxes(&boxes, [MARGIN, 0.0]);
        at_once.update(&Lists::new(&modified, &removed), &colliders, MARGIN);
        by_and_by.update(&Lists::new(&[], &removed), &colliders, MARGIN);
        modified.extend(boxes.iter().map(|(id, _)| id));
        for few in modified.chunks(250) {
            by_and_by.update(&Lists::new(few, &[]), &colliders, MARGIN);
        }
        // Some colliders get another key in the same place; some listed ones are unknown.
        let mut in_place = vec![(slots, 0)];
        for (slot, (generation, collider)) in (0..).zip(&mut colliders).step_by(3) {
            if slot % 7 == 0 {
                in_place.push((slot, *generation + 1));
                continue;
            }
            if let Some((_, key)) = collider {
                *key = Side((key.0 + slot % 2) % 3);
            }
            in_place.push((slot, *generation));
        }
        at_once.update(&in_place_of(&in_place), &colliders, MARGIN);
        for few in in_place.chunks(7) {
            by_and_by.update(&in_place_of(few), &colliders, MARGIN);
        }
        // `assert_eq` would print thousands of events.
        assert!(finish(&mut at_once, &colliders) == finish(&mut by_and_by, &colliders));
        let [a, b] = [&at_once, &by_and_by].map(|table| {
            let stats = table.stats();
            [stats.proxies, stats.refused, stats.pairs]
        });
        assert_eq!(a, b);
    }
    assert!(at_once.pairs::<Id>().count() > 0 && at_once.stats().refused > 0);
}

#[test]
fn colliders_are_read_alike_in_every_order() {
    for filter in [PairFilter::Groups, PairFilter::Shapes] {
        check(filter, 20_000, 8);
        for threads in [1, 2, 3, 8, 16] {
            with_threads(threads, || check(filter, 1000, 20));
        }
    }
}

#[test]
fn boxes_that_are_set_many_times_take_no_more_memory() {
    let aabb = |x: f32| Aabb::new([x, 0.0], [x + 1.0, 1.0]);
    let colliders = vec![(0, Some((aabb(0.0), Side(0)))); 6];
    let all = [0, 1, 2, 3, 4, 5].map(|slot| (slot, 0));
    let mut table = table(PairFilter::Shapes);
    // The other three are unknown.
    table.update(&Lists::new(&all[..3], &[]), &colliders, MARGIN);
    finish(&mut table, &colliders);
    for i in 0..2_000 {
        let boxes = all.map(|id| (id, aabb((i % 7) as f32)));
        table.set_boxes(&boxes, [MARGIN, 0.0]);
        let noted = table.touched().len() + table.pending.len();
        assert!(noted <= (MOST_NOTES_A_SLOT + 2) * all.len());
    }
}

#[test]
fn boxes_for_unknown_colliders_make_room_once() {
    let aabb = Aabb::new([0.0; 2], [1.0; 2]);
    let mut colliders = Colliders::new();
    let mut table = table(PairFilter::Groups);
    // Each slot is within reach of the one before.
    let set_boxes = |table: &mut Table, first: u32| {
        let step = ROOM_AHEAD as u32 - 1;
        let boxes: Vec<_> = (1..50).map(|i| ((first + i * step, 0), aabb)).collect();
        table.set_boxes(&boxes, [MARGIN, 0.0]);
    };
    for _ in 0..3 {
        set_boxes(&mut table, 0);
        table.update(&Lists::new(&[], &[]), &colliders, MARGIN);
        finish(&mut table, &colliders);
        assert_eq!(table.boxes().len(), ROOM_AHEAD);
    }
    // The reach grows with known colliders, and stays when they are gone.
    colliders.resize(2 * ROOM_AHEAD, (0, Some((aabb, Side(0)))));
    let last = (2 * ROOM_AHEAD as u32 - 1, 0);
    for lists in [Lists::new(&[last], &[]), Lists::new(&[], &[last])] {
        table.update(&lists, &colliders, MARGIN);
        finish(&mut table, &colliders);
    }
    set_boxes(&mut table, last.0 + 1);
    assert_eq!(table.boxes().len(), 3 * ROOM_AHEAD);
    table.validate();
}

#[test]
fn boxes_of_many_unknown_colliders_are_all_kept() {
    // Apart, for so many boxes in one place have more pairs than fit in the memory of a processor of 32 bits.
    let aabb = |slot: u32| Aabb::new([2.0 * slot as f32, 0.0], [2.0 * slot as f32 + 1.0, 1.0]);
    let boxes: Vec<_> = (0..20_000).map(|slot| ((slot, 0), aabb(slot))).collect();
    let colliders = boxes.iter().map(|&(_, aabb)| (0, Some((aabb, Side(1)))));
    let colliders = colliders.collect();
    for (threads, known) in [(8, 0), (8, 1), (16, 100), (16, 1000)] {
        let mut table = table(PairFilter::Groups);
        let ids: Vec<Id> = (0..known).map(|slot| (slot, 0)).collect();
        table.update(&Lists::new(&ids, &[]), &colliders, MARGIN);
        finish(&mut table, &colliders);
        with_threads(threads, || {
            table.set_boxes(&boxes, [MARGIN, 0.0]);
        });
        table.update(&Lists::new(&[], &[]), &colliders, MARGIN);
        finish(&mut table, &colliders);
        assert_eq!(table.stats().proxies, boxes.len());
    }
}

#[test]
fn colliders_beyond_the_most_slots_are_refused_and_all_others_searched() {
    const MOST: u32 = 100;
    let aabb = Aabb::new([0.0; 2], [1.0; 2]);
    let ids: Vec<Id> = (0..3 * MOST).map(|slot| (slot, 0)).collect();
    let mut colliders = vec![(0, Some((aabb, Side(0)))); ids.len()];
    let mut table = table(PairFilter::Groups);
    table.most_known_slots = MOST as usize;
    let check = |table: &mut Table, lists, colliders: &Colliders, refused| {
        table.update(&lists, colliders, MARGIN);
        let events = finish(table, colliders);
        let stats = table.stats();
        let pairs = (MOST * (MOST - 1) / 2) as usize;
        let counts = [stats.proxies, stats.refused, stats.pairs];
        assert_eq!(counts, [MOST as usize, refused, pairs]);
        assert!(table.boxes().len() <= MOST as usize + ROOM_AHEAD);
        assert!(table.boxes()[MOST as usize..].iter().all(|b| !b.is_valid()));
        events.len()
    };
    check(&mut table, Lists::new(&ids, &[]), &colliders, 200);
    assert!(table.has_warned);
    assert_eq!(check(&mut table, Lists::new(&ids, &[]), &colliders, 200), 0);

    // Queries see the box until the update.
    table.set_boxes(&[((250, 0), aabb)], [MARGIN, 0.0]);
    assert!(table.boxes()[250].is_valid());
    check(&mut table, Lists::new(&[], &[]), &colliders, 200);

    // One collider is removed, one never existed, one is listed after it is gone, and one has a new collider in its slot.
    let removed = [(200, 0), (201, 7)];
    check(&mut table, Lists::new(&[], &removed), &colliders, 199);
    (colliders[202].1, colliders[203].0) = (None, 1);
    let listed = [(202, 0), (203, 1)];
    check(&mut table, Lists::new(&listed, &[]), &colliders, 198);
    check(&mut table, Lists::new(&[], &[(203, 1)]), &colliders, 197);
}
