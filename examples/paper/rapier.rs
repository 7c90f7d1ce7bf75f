//! Rapier's bounding volume hierarchies as methods: that of version 0.27, which unisize replaces, and the newest.

mod v027;
mod v036;

use crate::method::Method;

/// Their names, in the order of [`hierarchies`].
pub(crate) const NAMES: [&str; 2] = ["Rapier 0.27, BVH", "Rapier 0.36, BVH"];

/// Both, for squares of side 1 that begin at these lower corners. They keep their trees from frame to frame, and hold more pairs
/// because their boxes have a margin.
pub(crate) fn hierarchies(mins: &[[f32; 2]]) -> Vec<Box<dyn Method<2>>> {
    vec![
        Box::new(v027::Hierarchy::new(mins)),
        Box::new(v036::Hierarchy::new(mins)),
    ]
}
