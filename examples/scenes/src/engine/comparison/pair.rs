//! An unordered pair of colliders.

use super::World;
use super::rapier::prelude::*;
use super::space::{components, own};
use std::fmt;

/// Two colliders, each as index and generation, the smaller first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Pair([(u32, u32); 2]);

impl Pair {
    pub(super) fn new(a: ColliderHandle, b: ColliderHandle) -> Self {
        let (a, b) = (a.into_raw_parts(), b.into_raw_parts());
        Self([a.min(b), a.max(b)])
    }

    /// The two colliders, the one with the smaller index first.
    pub(super) fn handles(self) -> [ColliderHandle; 2] {
        self.0
            .map(|(index, generation)| ColliderHandle::from_raw_parts(index, generation))
    }

    /// Whether the narrow phase of Rapier would drop this pair anyway, as the world is now.
    ///
    /// A pair with a collider that does not exist is not one of them: nobody should hold it.
    pub(super) fn is_dropped_by_narrow_phase(self, world: &World) -> bool {
        let [Some(a), Some(b)] = self.handles().map(|handle| world.colliders.get(handle)) else {
            return false;
        };
        !world.may_touch(a, b)
    }

    /// The pair with what its colliders are, and where.
    pub(super) fn describe(self, world: &World) -> String {
        let [a, b] = self.handles().map(|handle| {
            let (index, generation) = handle.into_raw_parts();
            match world.colliders.get(handle) {
                Some(collider) => format!(
                    "{index}:{generation} ({:?} at {:?}{}{})",
                    collider.shape().shape_type(),
                    components(own(collider.translation())),
                    if collider.is_sensor() { ", sensor" } else { "" },
                    if collider.is_enabled() {
                        ""
                    } else {
                        ", disabled"
                    },
                ),
                None => format!("{index}:{generation} (removed)"),
            }
        });
        format!("{a} - {b}")
    }
}

impl From<ColliderPair> for Pair {
    fn from(pair: ColliderPair) -> Self {
        Self::new(pair.collider1, pair.collider2)
    }
}

impl fmt::Display for Pair {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [(i, g), (j, h)] = self.0;
        write!(f, "{i}:{g} - {j}:{h}")
    }
}
