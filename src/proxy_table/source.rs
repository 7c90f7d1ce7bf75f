//! What an update is given: which colliders it is about, and where their boxes come from.

use std::fmt::Debug;

use crate::aabb::Aabb;
use crate::pair_tracker::FilterKey;
use crate::real::Real;
use crate::volume::Volume;

/// What an engine knows a collider by: a slot, and a generation.
pub(crate) trait Handle: Copy + Debug + Send + Sync {
    fn from_raw_parts(slot: u32, generation: u32) -> Self;
    fn into_raw_parts(self) -> (u32, u32);
}

/// Handles of colliders. A collider may be in several lists, or in one more than once.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lists<'a, H> {
    /// Those that are new, or may have another box or filter key.
    pub(crate) modified: &'a [H],
    /// Those of them whose boxes are renewed without a margin, wherever they are.
    pub(crate) reinserted: &'a [H],
    /// Those that may have another filter key, or another volume in the same pose. Their boxes stay as they are.
    pub(crate) unmoved: &'a [H],
    /// Those whose bodies have changed. Their boxes and filter keys stay as they are.
    pub(crate) swept: &'a [H],
    /// Those that are gone: their pairs end without an event.
    pub(crate) removed: &'a [H],
}

impl<'a, H> Lists<'a, H> {
    /// Modified and removed colliders alone.
    pub(crate) fn new(modified: &'a [H], removed: &'a [H]) -> Self {
        Self {
            modified,
            reinserted: &[],
            unmoved: &[],
            swept: &[],
            removed,
        }
    }

    pub(crate) fn are_empty(&self) -> bool {
        self.len() == 0
    }

    /// How many colliders are listed; those that are reinserted are among the modified ones.
    pub(crate) fn len(&self) -> usize {
        self.modified.len() + self.unmoved.len() + self.swept.len() + self.removed.len()
    }
}

/// Where the boxes of listed colliders are read.
pub(crate) trait BoxSource<R: Real, const D: usize>: Sync {
    type Handle: Handle;
    /// What is remembered of a collider between readings.
    type Memo: Clone + Default + Send;
    /// What decides which colliders may be a pair.
    type Key: FilterKey;

    /// The box of a collider, without the margin, and its filter key; `None` if it is gone or disabled.
    fn read(&self, handle: Self::Handle, memo: &mut Self::Memo) -> Option<(Aabb<R, D>, Self::Key)>;

    /// By how much the volumes of all colliders are extended.
    fn reach(&self) -> R;

    /// Whether anything has changed of a collider that is listed as [unmoved](Lists::unmoved), and that was read before.
    fn has_changed_unmoved(&self, handle: Self::Handle, memo: &Self::Memo) -> bool;

    /// Whether keys differ at all. If not, they need not be compared.
    fn has_keys(&self) -> bool;

    /// The volume of a collider that was just read, in the box that was read.
    fn volume(
        &self,
        handle: Self::Handle,
        memo: &mut Self::Memo,
        aabb: &Aabb<R, D>,
    ) -> Volume<R, D>;

    /// Reads a collider, its volume if volumes are used.
    fn reading(
        &self,
        handle: Self::Handle,
        memo: &mut Self::Memo,
        are_used: bool,
    ) -> Option<Reading<R, D, Self::Key>> {
        let (aabb, key) = self.read(handle, memo)?;
        let volume = match are_used {
            true => self.volume(handle, memo, &aabb),
            false => Volume::BOX,
        };
        Some(Reading { aabb, key, volume })
    }
}

/// What was read of a collider.
pub(crate) struct Reading<R, const D: usize, K> {
    pub(super) aabb: Aabb<R, D>,
    pub(super) key: K,
    pub(super) volume: Volume<R, D>,
}
