//! A table, its model, and the colliders that both are told of.

use std::collections::BTreeSet;

use oorandom::Rand32;

use super::model::Model;
use super::{Colliders, Id, MARGIN, Memo, SLACK, Side};
use crate::proxy_table::{Changes, Lists, ProxyTable};
use crate::{Aabb, Kernel, PairFilter, Settings, Stats};

/// Both in one world, and what is random about it.
pub(super) struct World {
    pub(super) random: Rand32,
    pub(super) side: f32,
    pub(super) colliders: Colliders,
    pub(super) table: ProxyTable<f32, 2, Memo, Side>,
    pub(super) model: Model,
}

impl World {
    pub(super) fn new(filter: PairFilter, slots: u32, seed: u64) -> Self {
        Self {
            random: Rand32::new(seed),
            side: (slots as f32 * 1.5).sqrt(),
            colliders: Colliders::default(),
            table: ProxyTable::new(&Settings::default().with_filter(filter)),
            model: Model::new(filter),
        }
    }

    pub(super) fn random_box(&mut self) -> Aabb<f32, 2> {
        let corner = [(); 2].map(|()| self.random.rand_float() * self.side);
        Aabb::new(corner, corner.map(|x| x + 1.0))
    }

    /// Changes the collider of a slot in some way, and says what is to be listed as modified and as removed.
    pub(super) fn change(&mut self, slot: u32, modified: &mut Vec<Id>, removed: &mut Vec<Id>) {
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
    pub(super) fn hand_over(&mut self, boxes: &[(Id, Aabb<f32, 2>)]) {
        let before = self.table.stats();
        let colliders = &self.colliders;
        self.table
            .hand_over(boxes.iter().copied(), MARGIN, |id, _, aabb| {
                colliders.volume_in(id, aabb)
            });
        for &(id, aabb) in boxes {
            self.model.hand_over(id, aabb, &self.colliders);
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
    pub(super) fn update(&mut self, modified: &[Id], removed: &[Id]) {
        self.table
            .update(&Lists::new(modified, removed), &self.colliders, MARGIN);
        self.model.update(modified, removed, &self.colliders);

        let [added, deleted] = self.model.finish();
        let mut events: Vec<(bool, [Id; 2])> = Vec::new();
        self.table.finish(
            SLACK,
            &mut Changes::default(),
            &mut events,
            |is_added, pair| (is_added, pair),
        );
        for &id in events.iter().flat_map(|(_, pair)| pair) {
            let known = self.model.known.get(&id.slot);
            assert!(
                known.is_some_and(|known| known.0 == id.generation),
                "{id:?}"
            );
        }
        // The sets of the model are in the order in which events are due.
        let due = deleted.iter().map(|&pair| (false, pair));
        let due = due.chain(added.iter().map(|&pair| (true, pair)));
        let found = events
            .iter()
            .map(|&(is_added, pair)| (is_added, pair.map(|id| id.slot)));
        assert!(found.eq(due), "{events:?}, but {deleted:?} and {added:?}");

        let stats = self.table.stats();
        assert_eq!(stats.moved, std::mem::take(&mut self.model.moved));
        let proxies = self
            .model
            .known
            .values()
            .filter(|known| known.1.is_some())
            .count();
        assert_eq!([stats.added, stats.deleted], [added.len(), deleted.len()]);
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
    pub(super) fn box_to_hand_over(&mut self, id: Id) -> Aabb<f32, 2> {
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
    pub(super) fn arrange(&mut self, ids: &mut [Id], is_sorted: bool) {
        if is_sorted {
            ids.sort();
        } else {
            for i in (1..ids.len()).rev() {
                ids.swap(i, self.random.rand_range(0..i as u32 + 1) as usize);
            }
        }
    }
}
