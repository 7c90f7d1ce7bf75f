//! A broad phase with a world of its own, of whichever version of Rapier.

use super::choreography::Choreography;
use crate::pair_set::PairSet;
use std::time::Duration;

pub(crate) trait Peer<const D: usize> {
    /// Moves the listed colliders to where they are now, given the centres of all.
    fn place(&mut self, centers: &[[f32; D]]);

    /// How long the broad phase takes to learn of it.
    fn update(&mut self) -> Duration;

    /// How much of the next update is only there because this thread has no other to do it beside the solver. Before
    /// anything is placed for that update.
    fn deferred(&mut self) -> Duration;

    /// The pairs that it holds, by the events that it has sent.
    fn held_pairs(&self) -> PairSet;
}

/// A broad phase that can be created for the colliders of a choreography, before its first frame.
pub(crate) struct Entry<const D: usize> {
    pub(crate) name: &'static str,
    /// The name of the one of unisize's that it is compared with.
    pub(crate) ours: &'static str,
    pub(crate) create: Create<D>,
    /// Whether it is measured with sizes as far apart as one to a hundred.
    pub(crate) takes_large: bool,
}

type Create<const D: usize> = fn(start: &Choreography<D>) -> Box<dyn Peer<D>>;
