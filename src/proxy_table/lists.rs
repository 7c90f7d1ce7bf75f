//! The colliders that an update is about.

/// Handles of colliders. A collider may be in several lists, or in one more than once.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lists<'a, H> {
    /// Those that are new, or may have another box or filter key.
    pub(crate) modified: &'a [H],
    /// Those of them whose boxes are renewed without a margin, wherever they are.
    pub(crate) reinserted: &'a [H],
    /// Those that may have another filter key. Their boxes stay as they are.
    pub(crate) unmoved: &'a [H],
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
            removed,
        }
    }

    pub(crate) fn are_empty(&self) -> bool {
        self.len() == 0
    }

    /// How many colliders are listed; those that are reinserted are among the modified ones.
    pub(crate) fn len(&self) -> usize {
        self.modified.len() + self.unmoved.len() + self.removed.len()
    }
}
