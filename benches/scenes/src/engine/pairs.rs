//! Pairs of colliders: what a broad phase says of one, and how two sets of them differ.

use super::rapier::prelude::*;
use super::space::{components, own};
use super::world::World;
use std::collections::HashSet;

/// Pairs of colliders, each [in order](in_order).
pub(super) type Pairs = HashSet<ColliderPair>;

/// A copy of [`BroadPhasePairEvent`], which is neither `Clone` nor `PartialEq`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PairEvent {
    /// The pair is new.
    Add(ColliderPair),
    /// The pair has ended.
    Delete(ColliderPair),
}

impl PairEvent {
    /// The pair that it is about.
    pub fn pair(self) -> ColliderPair {
        match self {
            Self::Add(pair) | Self::Delete(pair) => pair,
        }
    }

    /// Whether the pair is new.
    pub fn is_add(self) -> bool {
        matches!(self, Self::Add(_))
    }

    /// By this, new pairs come first, and then it is handles that count.
    pub(super) fn sort_key(self) -> (bool, [(u32, u32); 2]) {
        (!self.is_add(), handles(self.pair()))
    }
}

impl From<&BroadPhasePairEvent> for PairEvent {
    fn from(event: &BroadPhasePairEvent) -> Self {
        match event {
            BroadPhasePairEvent::AddPair(pair) => Self::Add(*pair),
            BroadPhasePairEvent::DeletePair(pair) => Self::Delete(*pair),
        }
    }
}

impl From<PairEvent> for BroadPhasePairEvent {
    fn from(event: PairEvent) -> Self {
        match event {
            PairEvent::Add(pair) => Self::AddPair(pair),
            PairEvent::Delete(pair) => Self::DeletePair(pair),
        }
    }
}

/// The pair with the smaller handle first, so that those of two broad phases are equal.
pub(super) fn in_order(pair: ColliderPair) -> ColliderPair {
    let [first, second] = handles(pair);
    if first <= second { pair } else { pair.swap() }
}

/// The index and the generation of either collider.
pub(super) fn handles(pair: ColliderPair) -> [(u32, u32); 2] {
    [pair.collider1, pair.collider2].map(ColliderHandle::into_raw_parts)
}

/// Whether the narrow phase makes something of this pair, as the world is now.
///
/// A pair with a collider that does not exist counts as well: nobody should hold it.
pub(super) fn is_relevant(pair: ColliderPair, world: &World) -> bool {
    match [pair.collider1, pair.collider2].map(|handle| world.colliders.get(handle)) {
        [Some(a), Some(b)] => world.may_touch(a, b),
        _ => true,
    }
}

/// Says of the first pair that is among these and not among the others what that means, and how many there are.
pub(super) fn difference(
    these: &Pairs,
    others: &Pairs,
    world: &World,
    meaning: &str,
    counts: impl Fn(ColliderPair) -> bool,
) -> Option<String> {
    let only = these.difference(others).filter(|&&pair| counts(pair));
    let only: Vec<_> = only.collect();
    // In an order that does not depend on hashing.
    let first = only.iter().min_by_key(|&&&pair| handles(pair))?;
    let pair = describe(**first, world);
    Some(format!("{pair} {meaning} ({} such in all)", only.len()))
}

/// A pair with what its colliders are, and where.
pub(super) fn describe(pair: ColliderPair, world: &World) -> String {
    let [a, b] = [pair.collider1, pair.collider2].map(|handle| {
        let (index, generation) = handle.into_raw_parts();
        let Some(collider) = world.colliders.get(handle) else {
            return format!("{index}:{generation} (removed)");
        };
        format!(
            "{index}:{generation} ({:?} at {:?}{}{})",
            collider.shape().shape_type(),
            components(own(collider.translation())),
            if collider.is_sensor() { ", sensor" } else { "" },
            if collider.is_enabled() {
                ""
            } else {
                ", disabled"
            },
        )
    });
    format!("{a} - {b}")
}
