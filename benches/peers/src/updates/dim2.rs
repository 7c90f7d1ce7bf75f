//! The broad phases for rapier2d.

mod v026;
mod v027;
mod v036;

use super::peer::Entry;

/// The one of this repository first, then the one that it replaces.
pub(super) const ENTRIES: [Entry<2>; 4] = [v027::OURS, v027::DEFAULT, v036::BVH, v026::MULTI_SAP];
