//! The observer of the pair tracker: it collects the changes of pairs, and knows which contacts are active.

use super::{Changes, Handle, handles};
use crate::pair_tracker::{PairChange, PairObserver};

/// Tells whether the contact of two colliders is active; see [`PairObserver::is_active`].
pub(crate) type IsActive<'a, H> = &'a (dyn Fn(H, H) -> bool + Sync);

/// Collects the changes of an update.
pub(super) struct Observer<'a, H> {
    pub(super) generations: &'a [Option<u32>],
    pub(super) is_active: Option<IsActive<'a, H>>,
    pub(super) changes: &'a mut Changes,
}

impl<H: Handle> PairObserver for Observer<'_, H> {
    fn report(&mut self, change: PairChange) {
        self.changes.note(change);
    }

    fn is_active(&self, pair: [u32; 2]) -> bool {
        self.is_active.is_some_and(|is_active| {
            let [first, second] = handles(self.generations, pair);
            is_active(first, second)
        })
    }
}
