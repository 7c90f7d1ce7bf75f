//! What a broad phase says of a pair, in a form that can be kept and compared.

use super::super::pairs::handles;
use super::super::rapier::prelude::*;

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
