//! What the table should hold, by the plainest means.

use std::collections::{BTreeMap, BTreeSet};

use super::{Colliders, Id, MARGIN, Side};
use crate::pair_tracker::FilterKey;
use crate::{Aabb, GridSweep, PairFinder};

/// What the table should hold.
#[derive(Default)]
pub(super) struct Model {
    /// Known colliders, with their boxes; none where the collider is refused.
    pub(super) known: BTreeMap<u32, (u32, Option<Aabb<f32, 2>>)>,
    pub(super) sides: BTreeMap<u32, Side>,
    pub(super) held: BTreeSet<[u32; 2]>,
    /// What the next update has to look for, with the boxes that were handed over.
    awaited: Vec<(Id, Option<Aabb<f32, 2>>)>,
    pub(super) moved: usize,
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
    pub(super) fn hand_over(&mut self, id: Id, aabb: Aabb<f32, 2>) {
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

    pub(super) fn update(&mut self, modified: &[Id], removed: &[Id], colliders: &Colliders) {
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
    pub(super) fn finish(&mut self) -> [BTreeSet<[u32; 2]>; 2] {
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
