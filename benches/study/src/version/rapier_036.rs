//! Rapier 0.36.

use crate::finder::Finder;

/// The version of Rapier.
pub(crate) const RAPIER: &str = "0.36";

/// The level that leaves out what the default broad phase leaves out: with it, and with events in order, both do the same to the bit.
pub(crate) const FILTER_OF_DEFAULT: unisize::PairFilter = unisize::PairFilter::Groups;

/// What `accuracy` simulates with.
pub(crate) const FINDERS: &[Finder] = &[
    Finder::Rapier,
    Finder::DEFAULT,
    Finder::Seldom(2, None),
    Finder::Lossy,
];

pub(crate) mod dim2 {
    pub(crate) use unisize::rapier2d_036 as ours;
    pub(crate) use unisize_scenes::dim2_036 as scenes;
}

pub(crate) mod dim3 {
    pub(crate) use unisize::rapier3d_036 as ours;
    pub(crate) use unisize_scenes::dim3_036 as scenes;
}
