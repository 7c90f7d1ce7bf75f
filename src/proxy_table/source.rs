//! Where the boxes of colliders come from.

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

/// Where the boxes of listed colliders are read.
pub(crate) trait BoxSource<R, const D: usize>: Sync {
    type Handle: Handle;
    /// What is remembered of a collider between readings.
    type Memo: Clone + Default + Send;
    /// What decides which colliders may be a pair.
    type Key: FilterKey;

    /// The box of a collider, without the margin, and its filter key; `None` if it is gone or disabled.
    fn read(&self, handle: Self::Handle, memo: &mut Self::Memo) -> Option<(Aabb<R, D>, Self::Key)>;

    /// Whether keys differ at all. If not, they need not be compared.
    fn has_keys(&self) -> bool;

    /// The volume of a collider that was just read, in the box that was read.
    fn volume(
        &self,
        handle: Self::Handle,
        memo: &mut Self::Memo,
        aabb: &Aabb<R, D>,
    ) -> Volume<R, D>;
}

/// What was read of a collider.
pub(super) struct Reading<R, const D: usize, K> {
    pub(super) aabb: Aabb<R, D>,
    pub(super) key: K,
    pub(super) volume: Volume<R, D>,
}

impl<R: Real, const D: usize, K> Reading<R, D, K> {
    /// Reads a collider, its volume if volumes are used.
    pub(super) fn of<S>(
        source: &S,
        handle: S::Handle,
        memo: &mut S::Memo,
        are_used: bool,
    ) -> Option<Self>
    where
        S: BoxSource<R, D, Key = K>,
    {
        let (aabb, key) = source.read(handle, memo)?;
        let volume = match are_used {
            true => source.volume(handle, memo, &aabb),
            false => Volume::BOX,
        };
        Some(Self { aabb, key, volume })
    }
}
