//! Rapier 0.36.

/// The version of Rapier.
pub(crate) const RAPIER: &str = "0.36";

/// The default of `--filter`, as the library has it.
pub(crate) const FILTER: &str = "shapes";

/// The level that leaves out what the default broad phase leaves out.
pub(crate) const FILTER_OF_DEFAULT: unisize::PairFilter = unisize::PairFilter::Groups;

pub(crate) mod dim2 {
    pub(crate) use unisize::rapier2d_036 as ours;
    pub(crate) use unisize_scenes::dim2_036 as scenes;
}

pub(crate) mod dim3 {
    pub(crate) use unisize::rapier3d_036 as ours;
    pub(crate) use unisize_scenes::dim3_036 as scenes;
}
