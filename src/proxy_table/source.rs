//! The input of an update: lists of colliders, and the source of their boxes.

use std::fmt::Debug;

use super::handles;
use crate::aabb::Aabb;
use crate::pair_tracker::{Colliders, FilterKey};
use crate::real::Real;
use crate::volume::Volume;

/// The engine's name of a collider: a slot and a generation.
pub(crate) trait Handle: Copy + Debug + Send + Sync {
    fn from_raw_parts(slot: u32, generation: u32) -> Self;
    fn into_raw_parts(self) -> (u32, u32);
}

/// Lists of colliders. A collider may be in several lists, and more than once in one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lists<'a, H> {
    /// New colliders, and those whose box or filter key may have changed.
    pub(crate) modified: &'a [H],
    /// The modified colliders whose boxes are renewed without a margin, even if they have not left them: those that a pipeline has listed again.
    /// Empty outside of a pipeline; there, a change of the key that [renews the box](FilterKey::renews_box) does the same.
    pub(crate) reinserted: &'a [H],
    /// Colliders whose filter key may have changed, or whose volume may have changed in the same pose. Their boxes stay.
    pub(crate) unmoved: &'a [H],
    /// Colliders of which anything may have changed, and their bodies. Their boxes stay.
    pub(crate) swept: &'a [H],
    /// Colliders that are gone. Their pairs end without an event.
    pub(crate) removed: &'a [H],
}

impl<'a, H> Lists<'a, H> {
    /// Lists of modified and removed colliders; the others are empty.
    pub(crate) fn new(modified: &'a [H], removed: &'a [H]) -> Self {
        Self {
            modified,
            reinserted: &[],
            unmoved: &[],
            swept: &[],
            removed,
        }
    }

    /// The number of listed colliders. The reinserted ones count as modified.
    pub(crate) fn len(&self) -> usize {
        self.modified.len() + self.unmoved.len() + self.swept.len() + self.removed.len()
    }
}

/// What a source remembers about a collider from one reading to the next.
pub(crate) trait Memo: Clone + Default + Send + Sync {}

impl<M: Clone + Default + Send + Sync> Memo for M {}

/// The source of the boxes of listed colliders.
pub(crate) trait ColliderSource<R: Real, const D: usize>: Sync {
    type Handle: Handle;
    type Memo: Memo;
    /// What decides, with the boxes, which colliders may be a pair.
    type Key: FilterKey;

    /// Reads the box of a collider and its filter key; `None` if the collider is gone or disabled.
    fn read(&self, handle: Self::Handle, memo: &mut Self::Memo)
    -> Option<Reading<R, D, Self::Key>>;

    /// Whether a known collider that is listed as [unmoved](Lists::unmoved) has changed since it was last read, with this key.
    fn has_changed_unmoved(&self, handle: Self::Handle, memo: &Self::Memo, key: &Self::Key)
    -> bool;

    /// The distance by which boxes are extended.
    fn reach(&self) -> R;

    /// The volume of a known collider, extended by this distance.
    fn volume(&self, handle: Self::Handle, memo: &Self::Memo, extension: R) -> Volume<R, D>;
}

/// What a source says of a collider.
pub(crate) struct Reading<R, const D: usize, K> {
    /// The box without the margin.
    pub(crate) aabb: Aabb<R, D>,
    pub(crate) key: K,
    /// Whether nothing but its pose can have changed its volume since the last reading.
    pub(crate) has_only_moved: bool,
    /// Whether the collider keeps the box that it had, or has none, because this one is infinite.
    pub(crate) is_skipped: bool,
}

/// Tells whether the contact of two colliders is active.
pub(crate) type IsActive<'a, H> = &'a (dyn Fn([H; 2]) -> bool + Sync);

/// The known colliders, by slot.
pub(super) struct Known<'a, S, H, M, R> {
    pub(super) source: &'a S,
    pub(super) is_active: Option<IsActive<'a, H>>,
    pub(super) generations: &'a [Option<u32>],
    pub(super) memos: &'a [M],
    pub(super) extension: R,
}

impl<R: Real, const D: usize, S: ColliderSource<R, D>> Colliders<R, D>
    for Known<'_, S, S::Handle, S::Memo, R>
{
    #[inline(always)]
    fn volume(&self, slot: u32) -> Volume<R, D> {
        let i = slot as usize;
        let Some(generation) = self.generations[i] else {
            return Volume::BOX;
        };
        let handle = S::Handle::from_raw_parts(slot, generation);
        self.source.volume(handle, &self.memos[i], self.extension)
    }

    fn is_active(&self, pair: [u32; 2]) -> bool {
        self.is_active
            .is_some_and(|is_active| is_active(handles(self.generations, pair)))
    }
}
