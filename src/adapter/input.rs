//! The input of an update, from a pipeline of Rapier's or from a program.

use super::rapier::dynamics::{IntegrationParameters, RigidBodySet};
use super::rapier::geometry::{ColliderHandle, ColliderSet};
use crate::pair_filter::PairFilter;
use crate::proxy_table::{IsActive, Lists};

/// The input of an update.
#[derive(Clone, Copy)]
pub(crate) struct Input<'a> {
    pub(crate) params: &'a IntegrationParameters,
    pub(crate) colliders: &'a ColliderSet,
    pub(crate) bodies: &'a RigidBodySet,
    pub(crate) lists: Lists<'a, ColliderHandle>,
    /// The filter of the broad phase, which sets it.
    pub(crate) filter: PairFilter,
    /// Whether a collider whose box is infinite is skipped, as Rapier's own broad phase does.
    pub(crate) skips_unbounded: bool,
    /// The listed colliders whose changes wake bodies.
    pub(crate) felt: &'a [ColliderHandle],
    /// Whether the narrow phase has an active contact or an intersection of two colliders; `None` if there is no narrow phase to ask.
    pub(crate) is_active: Option<IsActive<'a, ColliderHandle>>,
}

impl<'a> Input<'a> {
    /// The input outside of a pipeline.
    pub(crate) fn new(
        params: &'a IntegrationParameters,
        colliders: &'a ColliderSet,
        bodies: &'a RigidBodySet,
        modified: &'a [ColliderHandle],
        removed: &'a [ColliderHandle],
    ) -> Self {
        Self {
            params,
            colliders,
            bodies,
            lists: Lists::new(modified, removed),
            filter: PairFilter::Off,
            skips_unbounded: false,
            felt: &[],
            is_active: None,
        }
    }
}
