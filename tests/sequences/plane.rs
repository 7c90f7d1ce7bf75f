//! Solids of revolution: there are none in the plane.

use super::suite::Solid;

pub(super) const SOLIDS: [(&str, Solid); 0] = [];
