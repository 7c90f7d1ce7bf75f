//! Rapier 0.27.

use crate::finder::{Cell, Finder};

/// The version of Rapier.
pub(crate) const RAPIER: &str = "0.27";

/// The level that leaves out what the default broad phase leaves out: with it, and with events in order, both do the same to the bit.
pub(crate) const FILTER_OF_DEFAULT: unisize::PairFilter = unisize::PairFilter::Off;

/// What `accuracy` simulates with.
pub(crate) const FINDERS: &[Finder] = &[
    Finder::Rapier,
    Finder::DEFAULT,
    Finder::Seldom(2, None),
    Finder::Grid(Cell::Largest),
    Finder::Grid(Cell::Median),
    Finder::Lossy,
];

pub(crate) mod dim2 {
    pub(crate) use unisize::rapier2d_027 as ours;
    pub(crate) use unisize_scenes::dim2 as scenes;
}

pub(crate) mod dim3 {
    pub(crate) use unisize::rapier3d_027 as ours;
    pub(crate) use unisize_scenes::dim3 as scenes;
}
