//! Colliders that are left out.

use super::{Handle, Memo, ProxyTable};
use crate::aabb::Aabb;
use crate::pair_tracker::FilterKey;
use crate::real::Real;

impl<R: Real, const D: usize, M: Memo, K: FilterKey> ProxyTable<R, D, M, K> {
    /// The number of colliders that are left out: known ones without a box, and those beyond the maximum.
    pub(super) fn refused(&self) -> usize {
        self.known - self.stats.proxies + self.beyond.len()
    }

    /// Leaves out a collider whose box is invalid, or infinite where such boxes are skipped.
    #[cold]
    pub(super) fn refuse(&mut self, handle: impl Handle, aabb: Aabb<R, D>) {
        let slot = handle.into_raw_parts().0;
        if self.tracker.proxies.get(slot).is_some() {
            self.tracker.proxies.clear_box(slot);
            self.stats.proxies -= 1;
        }
        self.warn(
            handle,
            format_args!("until its box is finite and valid: {aabb:?}"),
        );
    }

    /// Leaves out a collider whose slot is beyond the maximum.
    #[cold]
    pub(super) fn refuse_slot(&mut self, handle: impl Handle) {
        let (slot, generation) = handle.into_raw_parts();
        self.beyond.insert(slot, generation);
        let most = self.most_known_slots;
        self.warn(
            handle,
            format_args!("because its index is not less than {most}"),
        );
    }

    /// Logs why, or until when, the first such collider is left out.
    fn warn(&mut self, handle: impl Handle, why: std::fmt::Arguments<'_>) {
        if !std::mem::replace(&mut self.has_warned, true) {
            log::warn!(
                "collider {handle:?} is left out of the broad phase {why}. Further ones are only counted, in Stats::refused."
            );
        }
    }
}
