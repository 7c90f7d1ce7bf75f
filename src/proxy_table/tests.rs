//! The table against a model, by random sequences, from both sources of boxes and in every order of reading.

mod model;
mod world;

use super::{BoxSource, Changes, FilterKey, Handle, Lists};
use crate::tuning::update::{MOST_NOTES_A_SLOT, READ_AS_LISTED_UP_TO, ROOM_AHEAD, THREADS_FROM};
use crate::volume::{Volume, VolumeKind};
use crate::{Aabb, Kernel, PairFilter};
use world::World;

const MARGIN: f32 = 0.125;

/// How far the volumes of a held pair may be apart.
const SLACK: f32 = 0.25;

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

impl Collider {
    /// One that has just been made.
    fn at(aabb: Aabb<f32, 2>) -> Self {
        Self {
            generation: 0,
            aabb,
            side: Side::default(),
            exists: true,
            is_enabled: true,
        }
    }
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

    fn volume(&self, id: Id, memo: &mut Memo, aabb: &Aabb<f32, 2>) -> Volume<f32, 2> {
        assert_eq!(memo.owner, Some(id));
        self.volume_read(id, aabb)
    }
}

impl Colliders {
    fn is_part(id: Id) -> bool {
        (id.slot + id.generation) % 5 == 4
    }

    /// By slot and generation, volumes of every kind.
    fn volume_read(&self, id: Id, aabb: &Aabb<f32, 2>) -> Volume<f32, 2> {
        match Self::is_part(id) {
            true => Volume::PART,
            false => self.volume_in(id, aabb),
        }
    }

    /// By slot and generation, volumes of every kind that a box may be handed over with.
    fn volume_in(&self, id: Id, aabb: &Aabb<f32, 2>) -> Volume<f32, 2> {
        let Some(collider) = self.get(id) else {
            return Volume::BOX;
        };
        let Aabb { mins, maxs } = collider.aabb;
        let center = [0, 1].map(|k| (mins[k] + maxs[k]) / 2.0);
        assert!(!Self::is_part(id), "nobody looks at a part");
        let volume = match (id.slot + id.generation) % 5 {
            0 => Volume::new(VolumeKind::Capsule, center, 0.25, &[[0.25, 0.125]]),
            1 => Volume::new(
                VolumeKind::Cuboid,
                center,
                0.125,
                &[[0.25, 0.125], [-0.125, 0.25]],
            ),
            2 => Volume::BOX,
            _ => Volume::new(VolumeKind::Ball, center, 0.5, &[]),
        };
        volume.in_box(aabb)
    }
}

fn check(slots: u32, updates: usize, seed: u64) {
    for filter in [PairFilter::Groups, PairFilter::Shapes] {
        check_with(filter, slots, updates, seed);
    }
}

fn check_with(filter: PairFilter, slots: u32, updates: usize, seed: u64) {
    let mut world = World::new(filter, slots, seed);
    for _ in 0..slots {
        let aabb = world.random_box();
        world.colliders.slots.push(Collider::at(aabb));
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
    let mut world = World::new(PairFilter::Groups, 4, 6);
    let aabb = Aabb::new([0.0; 2], [1.0; 2]);
    let collider = Collider::at(aabb);
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

#[test]
fn boxes_handed_over_again_and_again_take_no_more_memory() {
    const COLLIDERS: u32 = 6;
    let mut world = World::new(PairFilter::Shapes, COLLIDERS, 8);
    for _ in 0..COLLIDERS {
        let aabb = world.random_box();
        world.colliders.slots.push(Collider::at(aabb));
    }
    let all: Vec<_> = (0..COLLIDERS)
        .map(|slot| world.colliders.id(slot))
        .collect();
    // The others are not known.
    world.update(&all[..COLLIDERS as usize / 2], &[]);
    for _ in 0..2_000 {
        let boxes: Vec<_> = all.iter().map(|&id| (id, world.random_box())).collect();
        world.hand_over(&boxes);
        let noted = world.table.touched().len() + world.table.awaited.len();
        assert!(noted <= (MOST_NOTES_A_SLOT + 2) * all.len());
    }
    world.update(&[], &[]);
}

#[test]
fn boxes_for_unknown_colliders_make_room_once() {
    let mut world = World::new(PairFilter::Groups, 2, 7);
    let aabb = Aabb::new([0.0; 2], [1.0; 2]);
    let step = ROOM_AHEAD as u32 - 1;
    // Each within reach of the one before.
    let bogus = |first: u32| {
        (1..50).map(move |i| {
            let slot = first + i * step;
            (
                Id {
                    slot,
                    generation: 0,
                },
                aabb,
            )
        })
    };
    for _ in 0..3 {
        world
            .table
            .hand_over(bogus(0), MARGIN, |_, _, _| Volume::BOX);
        assert_eq!(world.table.boxes().len(), ROOM_AHEAD);
        world
            .table
            .update(&Lists::new(&[], &[]), &world.colliders, MARGIN);
        world.table.finish(
            0.0,
            &mut Changes::default(),
            &mut Vec::<[Id; 2]>::new(),
            |_, ids| ids,
        );
        world.table.validate(Kernel::GridSweep);
        assert_eq!(world.table.boxes().len(), ROOM_AHEAD);
    }
    // The reach follows colliders that exist, and stays when they are gone.
    let collider = Collider::at(aabb);
    world.colliders.slots.resize(
        2 * ROOM_AHEAD,
        Collider {
            exists: false,
            ..collider
        },
    );
    *world.colliders.slots.last_mut().unwrap() = collider;
    let last = world.colliders.id(2 * ROOM_AHEAD as u32 - 1);
    world.update(&[last], &[]);
    world.update(&[], &[last]);
    world
        .table
        .hand_over(bogus(last.slot + 1), MARGIN, |_, _, _| Volume::BOX);
    assert_eq!(world.table.boxes().len(), 3 * ROOM_AHEAD);
    world.table.validate(Kernel::GridSweep);
}
