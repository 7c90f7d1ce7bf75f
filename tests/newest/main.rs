//! Rapier 0.36, whose pipelines accept no broad phase but their own: ours beside it.
//!
//! `driven` calls both broad phases with the same lists, `stepped` follows Rapier's own `PhysicsPipeline` and compares
//! with what its narrow phase holds, and `queries` asks both the same. `tests/sequences` checks random updates against
//! a model as well.

#[path = "."]
mod dim2 {
    use rapier2d_036 as rapier;
    use unisize::rapier2d_036::{PairFilter, Settings, UnisizeBroadPhase};

    mod suite;
}

#[path = "."]
mod dim3 {
    use rapier3d_036 as rapier;
    use unisize::rapier3d_036::{PairFilter, Settings, UnisizeBroadPhase};

    mod suite;
}

#[path = "."]
mod dim2_f64 {
    use rapier2d_f64_036 as rapier;
    use unisize::rapier2d_f64_036::{PairFilter, Settings, UnisizeBroadPhase};

    mod suite;
}

#[path = "."]
mod dim3_f64 {
    use rapier3d_f64_036 as rapier;
    use unisize::rapier3d_f64_036::{PairFilter, Settings, UnisizeBroadPhase};

    mod suite;
}
