//! Layers as they are written and read by serde.
//!
//! The order of a layer is that of a run of the kernel over its members, so it is enough to know these: the slots that
//! have not escaped since, with their present fat boxes, and those outdated ones that were members, with the fat boxes
//! that they had.

use serde::{Deserialize, Serialize};

use super::{GridLayers, Layer, Layers, collect_valid};
use crate::pair_tracker::absent;
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
        let members = base.restore(&mut layers.base, boxes)?;
        let mut slots = Vec::new();
        collect_valid(&members, &mut slots);
        layers.base.order_again(&members, &slots);

        let members = delta.restore(&mut layers.delta, boxes)?;
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
            members.resize(slots, absent());
            for (slot, aabb) in self.order.members() {
                members[slot as usize] = aabb;
            }
        }
        let member = |slot: u32| members.get(slot as usize).copied();
        let member = |slot| member(slot).filter(Aabb::is_valid);
        LayerSnapshot {
            is_sorted: self.is_sorted,
            outdated: outdated.iter().map(|&slot| (slot, member(slot))).collect(),
            spent: saturated(self.spent as u64),
        }
    }

    /// Sorts the members as they were sorted before.
    fn order_again(&mut self, boxes: &[Aabb<R, D>], members: &[u32]) {
        if self.is_sorted {
            let mut stopwatch = Stopwatch::default();
            self.order
                .find_among(boxes, members, &mut Vec::new(), &mut stopwatch);
        }
    }
}

impl<R: Real, const D: usize> LayerSnapshot<R, D> {
    /// Makes this the layer, except for its order, and returns the boxes to sort it by.
    fn restore(
        self,
        layer: &mut Layer<R, D>,
        boxes: &[Aabb<R, D>],
    ) -> Result<Vec<Aabb<R, D>>, &'static str> {
        let mut members = boxes.to_vec();
        let mut outdated = SlotSet::default();
        outdated.make_room(boxes.len());
        let count = self.outdated.len();
        for (slot, aabb) in self.outdated {
            let member = members.get_mut(slot as usize);
            let member = member.ok_or("snapshot: a slot of a layer is out of range")?;
            outdated.insert(slot);
            *member = aabb.unwrap_or(absent());
            if aabb.is_some_and(|aabb| !aabb.is_valid()) {
                return Err("snapshot: a box of a layer is not valid");
            }
        }
        if outdated.slots().len() < count {
            return Err("snapshot: a slot is outdated twice");
        }
        layer.is_sorted = self.is_sorted;
        layer.outdated = outdated;
        layer.spent = self.spent as usize;
        Ok(members)
    }
}

fn saturated(count: u64) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}
