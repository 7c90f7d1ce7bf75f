//! Rapier 0.36, whose pipelines take no other broad phase than their own: ours beside it.
//!
//! `driven` calls both broad phases with the same lists, `stepped` follows Rapier's own `PhysicsPipeline` and compares
//! with what its narrow phase holds, and `queries` asks both the same. What is random here is checked against a model too, in
//! `tests/sequences`.

#[path = "."]
mod dim2 {
    use rapier2d_0_36 as rapier;
    use unisize::rapier2d_0_36::{Settings, UnisizeBroadPhase};

    mod suite;
}

#[path = "."]
mod dim3 {
    use rapier3d_0_36 as rapier;
    use unisize::rapier3d_0_36::{Settings, UnisizeBroadPhase};

    mod suite;
}
