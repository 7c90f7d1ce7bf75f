//! Rapier 0.27.

/// The version of Rapier.
pub(crate) const RAPIER: &str = "0.27";

/// The default of `--filter`, as the library has it.
pub(crate) const FILTER: &str = "off";

/// The level that leaves out what the default broad phase leaves out.
pub(crate) const FILTER_OF_DEFAULT: unisize::PairFilter = unisize::PairFilter::Off;

pub(crate) mod dim2 {
    pub(crate) use unisize::rapier2d_027 as ours;
    pub(crate) use unisize_scenes::dim2 as scenes;
}

pub(crate) mod dim3 {
    pub(crate) use unisize::rapier3d_027 as ours;
    pub(crate) use unisize_scenes::dim3 as scenes;
}
