//! Layers as they are written and read by serde.
//!
//! The order of a layer is that of a run of the kernel over its members, so it is enough to know the members: slots that
//! have not escaped since, with their present fat boxes, and outdated slots that were members, with the fat boxes that they
//! had.

use serde::{Deserialize, Serialize};

use super::{GridLayers, Layer, Layers, collect_valid, log_too_many};
use crate::slot_set::SlotSet;
use crate::stopwatch::Stopwatch;
use crate::{Aabb, Real};

/// The layers; empty for kernels that have none.
#[derive(Serialize, Deserialize)]
#[serde(bound(serialize = "R: Serialize", deserialize = "R: Real + Deserialize<'de>"))]
pub(in crate::pair_tracker) struct LayersSnapshot<R, const D: usize> {
    base: LayerSnapshot<R, D>,
    delta: LayerSnapshot<R, D>,
}

#[derive(Serialize, Deserialize)]
#[serde(bound(serialize = "R: Serialize", deserialize = "R: Real + Deserialize<'de>"))]
struct LayerSnapshot<R, const D: usize> {
    is_sorted: bool,
    /// In the order in which they came, with the boxes that they had if they were members.
    outdated: Vec<(u32, Option<Aabb<R, D>>)>,
    /// Since the last full run, so 32 bits are enough.
    spent: u32,
}

impl<R: Real, const D: usize> Layers<R, D> {
    /// The layers of this many slots.
    pub(in crate::pair_tracker) fn snapshot(&self, slots: usize) -> LayersSnapshot<R, D> {
        let default = GridLayers::new(true);
        let layers = match self {
            Self::Grid(layers) => layers,
            Self::Rank(_) | Self::Brute(_) => &default,
        };
        LayersSnapshot {
            base: layers.base.snapshot(slots),
            delta: layers.delta.snapshot(slots),
        }
    }

    /// Makes these the layers of boxes.
    pub(in crate::pair_tracker) fn restore(
        &mut self,
        snapshot: LayersSnapshot<R, D>,
        boxes: &[Aabb<R, D>],
    ) -> Result<(), &'static str> {
        let Self::Grid(layers) = self else {
            return Ok(());
        };
        let LayersSnapshot { base, delta } = snapshot;
        let members = layers.base.restore(base, boxes)?;
        let mut slots = Vec::new();
        collect_valid(&members, &mut slots);
        layers.base.order_again(&members, &slots);

        let members = layers.delta.restore(delta, boxes)?;
        let outdated = &layers.base.outdated;
        let mut later = layers.delta.outdated.slots().iter();
        if !later.all(|&slot| outdated.contains(slot)) {
            return Err("snapshot: a slot is outdated in the delta layer and not in the base");
        }
        slots.clear();
        slots.extend_from_slice(outdated.slots());
        slots.retain(|&slot| members[slot as usize].is_valid());
        layers.delta.order_again(&members, &slots);
        Ok(())
    }
}

impl<R: Real, const D: usize> Layer<R, D> {
    fn snapshot(&self, slots: usize) -> LayerSnapshot<R, D> {
        let outdated = self.outdated.slots();
        let mut members = Vec::new();
        if self.is_sorted && !outdated.is_empty() {
            members.resize(slots, Aabb::ABSENT);
            for (slot, aabb) in self.order.members() {
                members[slot as usize] = aabb;
            }
        }
        let member = |slot: u32| members.get(slot as usize).copied();
        let member = |slot| member(slot).filter(Aabb::is_valid);
        LayerSnapshot {
            is_sorted: self.is_sorted,
            outdated: outdated.iter().map(|&slot| (slot, member(slot))).collect(),
            spent: u32::try_from(self.spent).unwrap_or(u32::MAX),
        }
    }

    /// Goes on from where another layer was, except for its order, and returns the boxes to sort it by.
    fn restore(
        &mut self,
        snapshot: LayerSnapshot<R, D>,
        boxes: &[Aabb<R, D>],
    ) -> Result<Vec<Aabb<R, D>>, &'static str> {
        let mut members = boxes.to_vec();
        let mut outdated = SlotSet::default();
        outdated.make_room(boxes.len());
        let count = snapshot.outdated.len();
        for (slot, aabb) in snapshot.outdated {
            let member = members.get_mut(slot as usize);
            let member = member.ok_or("snapshot: a slot of a layer is out of range")?;
            outdated.insert(slot);
            *member = aabb.unwrap_or(Aabb::ABSENT);
            if aabb.is_some_and(|aabb| !aabb.is_valid()) {
                return Err("snapshot: a box of a layer is not valid");
            }
        }
        if outdated.slots().len() < count {
            return Err("snapshot: a slot is outdated twice");
        }
        self.is_sorted = snapshot.is_sorted;
        self.outdated = outdated;
        self.spent = snapshot.spent as usize;
        Ok(members)
    }

    /// Sorts the members as they were sorted before.
    fn order_again(&mut self, boxes: &[Aabb<R, D>], members: &[u32]) {
        if self.is_sorted {
            let mut stopwatch = Stopwatch::default();
            let run = self
                .order
                .find_among(boxes, members, &mut Vec::new(), &mut stopwatch);
            run.unwrap_or_else(log_too_many);
        }
    }
}
