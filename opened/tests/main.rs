//! Rapier 0.36's own pipelines, with ours in the place of its broad phase and with its own, side by side.
//!
//! [`Twins`](dim2) step two equal worlds and compare, after every step, what a user can see: contacts, intersections, events,
//! sleep, poses, soft bodies. In most worlds no body meets more than one other, so that the order in which the solver gets the
//! contacts cannot matter and everything must be the same to the last bit. Where it does matter (`piles`) each world goes its
//! own way, and what Rapier's narrow phase knows is held to what touches by the shapes.
//!
//! With `--features parallel` Rapier uses its threads, with `--features unisize-parallel` ours does.

mod dim2 {
    use flavour::{floors, hinge, soft_body, spin};
    use rapier2d as rapier;
    use unisize::rapier2d_036::{PairFilter, Settings, UnisizeBroadPhase};

    mod flavour;
    #[path = "../suite/mod.rs"]
    mod suite;
}

mod dim3 {
    use flavour::{floors, hinge, soft_body, spin};
    use rapier3d as rapier;
    use unisize::rapier3d_036::{PairFilter, Settings, UnisizeBroadPhase};

    mod flavour;
    #[path = "../suite/mod.rs"]
    mod suite;
    mod vehicles;
}

#[path = "dim2"]
mod dim2_f64 {
    use flavour::{floors, hinge, soft_body, spin};
    use rapier2d_f64 as rapier;
    use unisize::rapier2d_f64_036::{PairFilter, Settings, UnisizeBroadPhase};

    mod flavour;
    #[path = "../suite/mod.rs"]
    mod suite;
}

#[path = "dim3"]
mod dim3_f64 {
    use flavour::{floors, hinge, soft_body, spin};
    use rapier3d_f64 as rapier;
    use unisize::rapier3d_f64_036::{PairFilter, Settings, UnisizeBroadPhase};

    mod flavour;
    #[path = "../suite/mod.rs"]
    mod suite;
    mod vehicles;
}
