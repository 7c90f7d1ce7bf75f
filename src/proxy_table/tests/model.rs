//! What the table should hold, by the plainest means.

use std::collections::{BTreeMap, BTreeSet};

use super::{Colliders, Id, MARGIN, SLACK, Side};
use crate::pair_tracker::{FilterKey, VOLUME_MARGIN};
use crate::volume::{Volume, VolumeKind};
use crate::{Aabb, GridSweep, PairFilter, PairFinder};

/// What the table should hold.
pub(super) struct Model {
    filter: PairFilter,
    /// And whether they are slow.
    volumes: BTreeMap<u32, (Volume<f32, 2>, bool)>,
    /// The boxes at the end of the last update.
    before: BTreeMap<u32, Aabb<f32, 2>>,
    /// Known colliders, with their boxes; none where the collider is refused.
    pub(super) known: BTreeMap<u32, (u32, Option<Aabb<f32, 2>>)>,
    pub(super) sides: BTreeMap<u32, Side>,
    pub(super) held: BTreeSet<[u32; 2]>,
    /// What the next update has to look for: with the box that the boxes handed over make, and the last of these.
    awaited: BTreeMap<Id, Option<[Aabb<f32, 2>; 2]>>,
    pub(super) moved: usize,
}

impl Model {
    pub(super) fn new(filter: PairFilter) -> Self {
        Self {
            filter,
            volumes: BTreeMap::new(),
            before: BTreeMap::new(),
            known: BTreeMap::new(),
            sides: BTreeMap::new(),
            held: BTreeSet::new(),
            awaited: BTreeMap::new(),
            moved: 0,
        }
    }

    fn remove(&mut self, id: Id) {
        if self
            .known
            .get(&id.slot)
            .is_some_and(|known| known.0 == id.generation)
        {
            self.known.remove(&id.slot);
            self.before.remove(&id.slot);
            self.held.retain(|pair| !pair.contains(&id.slot));
        }
    }

    /// A known collider keeps its side.
    pub(super) fn hand_over(&mut self, id: Id, aabb: Aabb<f32, 2>, colliders: &Colliders) {
        match self.known.get_mut(&id.slot) {
            Some(known) if known.0 == id.generation => {
                let side = self.sides[&id.slot];
                // A ball needs nothing but its box, and a part not even that.
                let former = self.volumes[&id.slot].0;
                let volume = match former.kind {
                    VolumeKind::Ball | VolumeKind::Part => former.in_box(&aabb),
                    _ => colliders.volume_in(id, &aabb),
                };
                return self.read(id, Some((aabb, side, volume)));
            }
            Some((generation, held)) => {
                // Queries find the box in its slot. If that is wrong, the next update puts it right.
                let outdated = Id {
                    generation: *generation,
                    ..id
                };
                self.awaited.insert(outdated, None);
                if aabb.is_valid() {
                    *held = Some(aabb);
                }
            }
            None => {}
        }
        let awaited = self.awaited.entry(id).or_default();
        let held = match awaited.map(|[held, _]| held) {
            Some(held) if held.is_valid() && aabb.is_valid() => match held.contains(&aabb) {
                true => held,
                false => aabb.loosened(MARGIN),
            },
            _ => aabb,
        };
        *awaited = Some([held, aabb]);
    }

    pub(super) fn update(&mut self, modified: &[Id], removed: &[Id], colliders: &Colliders) {
        let read = |id| {
            let collider = colliders.get(id).filter(|collider| collider.is_enabled);
            collider.map(|collider| {
                let volume = colliders.volume_read(id, &collider.aabb);
                (collider.aabb, collider.side, volume)
            })
        };
        removed.iter().for_each(|&id| self.remove(id));
        for (id, boxes) in std::mem::take(&mut self.awaited) {
            if !removed.contains(&id) {
                let found = read(id).map(|(found, side, volume)| match boxes {
                    Some([held, last]) => (held, side, volume.in_box(&last)),
                    None => (found, side, volume),
                });
                self.read(id, found);
            }
        }
        modified.iter().for_each(|&id| self.read(id, read(id)));
    }

    fn read(&mut self, id: Id, found: Option<(Aabb<f32, 2>, Side, Volume<f32, 2>)>) {
        let Some((aabb, side, volume)) = found else {
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
            Some(held) if aabb.is_valid() && held.contains(&aabb) => {
                let former = self.volumes.get_mut(&id.slot).unwrap();
                if former.0.kind != volume.kind {
                    *former = (volume, false);
                    return;
                }
                let change = former.0.as_ref().change_to(volume.as_ref());
                if change <= VOLUME_MARGIN as f32 * MARGIN {
                    former.1 |= change > 0.0;
                } else {
                    former.0 = volume;
                }
                return;
            }
            Some(_) if aabb.is_valid() => Some(aabb.loosened(MARGIN)),
            None if !aabb.is_valid() => {
                self.volumes.insert(id.slot, (volume, false));
                return;
            }
            _ => aabb.is_valid().then_some(aabb),
        };
        self.volumes.insert(id.slot, (volume, false));
        *held = renewed;
        self.moved += 1;
    }

    /// Whether a pair whose boxes overlap is held.
    fn volumes_meet(&self, pair: [u32; 2]) -> bool {
        if self.filter != PairFilter::Shapes {
            return true;
        }
        let [(a, is_slow), (b, is_other_slow)] = pair.map(|slot| self.volumes[&slot]);
        let margins = [is_slow, is_other_slow].map(|is_slow| f32::from(is_slow) * MARGIN);
        let margins = (margins[0] + margins[1]) * VOLUME_MARGIN as f32;
        let is_renewed = |slot| self.before.get(slot) != self.known[slot].1.as_ref();
        match self.held.contains(&pair) {
            false => a.meets(&b, margins),
            true => !pair.iter().any(is_renewed) || a.meets(&b, SLACK + margins),
        }
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
            a.may_meet(b) && self.volumes_meet(*pair)
        });
        let held = held.collect();
        let boxes = self.known.iter();
        self.before = boxes
            .filter_map(|(&slot, known)| Some((slot, known.1?)))
            .collect();
        let before = std::mem::replace(&mut self.held, held);
        let added = self.held.difference(&before).copied().collect();
        let deleted = before.difference(&self.held).copied().collect();
        [added, deleted]
    }
}
