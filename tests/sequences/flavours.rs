//! The suite in each flavour of Rapier, with what depends on its version. The fuzzer compiles this file as well.

#[path = "."]
pub(crate) mod dim2 {
    use rapier2d as rapier;
    use unisize::rapier2d_027::{Kernel, Settings, UnisizeBroadPhase};

    #[cfg(test)]
    #[path = "plane.rs"]
    mod solids;
    mod suite;
    #[path = "rapier_027/mod.rs"]
    mod version;

    pub(crate) use suite::play;
}

#[path = "."]
pub(crate) mod dim3 {
    use rapier3d as rapier;
    use unisize::rapier3d_027::{Kernel, Settings, UnisizeBroadPhase};

    #[cfg(test)]
    #[path = "space.rs"]
    mod solids;
    mod suite;
    #[path = "rapier_027/mod.rs"]
    mod version;

    pub(crate) use suite::play;
}

#[path = "."]
pub(crate) mod dim2_f64 {
    use rapier2d_f64 as rapier;
    use unisize::rapier2d_f64_027::{Kernel, Settings, UnisizeBroadPhase};

    #[cfg(test)]
    #[path = "plane.rs"]
    mod solids;
    mod suite;
    #[path = "rapier_027/mod.rs"]
    mod version;

    pub(crate) use suite::play;
}

#[path = "."]
pub(crate) mod dim3_f64 {
    use rapier3d_f64 as rapier;
    use unisize::rapier3d_f64_027::{Kernel, Settings, UnisizeBroadPhase};

    #[cfg(test)]
    #[path = "space.rs"]
    mod solids;
    mod suite;
    #[path = "rapier_027/mod.rs"]
    mod version;

    pub(crate) use suite::play;
}

#[path = "."]
pub(crate) mod dim2_036 {
    use rapier2d_036 as rapier;
    use unisize::rapier2d_036::{Kernel, Settings, UnisizeBroadPhase};

    #[cfg(test)]
    #[path = "plane.rs"]
    mod solids;
    mod suite;
    #[path = "rapier_036/mod.rs"]
    mod version;

    pub(crate) use suite::play;
}

#[path = "."]
pub(crate) mod dim3_036 {
    use rapier3d_036 as rapier;
    use unisize::rapier3d_036::{Kernel, Settings, UnisizeBroadPhase};

    #[cfg(test)]
    #[path = "space.rs"]
    mod solids;
    mod suite;
    #[path = "rapier_036/mod.rs"]
    mod version;

    pub(crate) use suite::play;
}

#[path = "."]
pub(crate) mod dim2_f64_036 {
    use rapier2d_f64_036 as rapier;
    use unisize::rapier2d_f64_036::{Kernel, Settings, UnisizeBroadPhase};

    #[cfg(test)]
    #[path = "plane.rs"]
    mod solids;
    mod suite;
    #[path = "rapier_036/mod.rs"]
    mod version;

    pub(crate) use suite::play;
}

#[path = "."]
pub(crate) mod dim3_f64_036 {
    use rapier3d_f64_036 as rapier;
    use unisize::rapier3d_f64_036::{Kernel, Settings, UnisizeBroadPhase};

    #[cfg(test)]
    #[path = "space.rs"]
    mod solids;
    mod suite;
    #[path = "rapier_036/mod.rs"]
    mod version;

    pub(crate) use suite::play;
}
