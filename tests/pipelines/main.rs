//! Whole worlds stepped with ours and with Rapier's own broad phase, side by side.
//!
//! `Twins` steps two equal worlds and compares, after every step, what a user can
//! see: contacts, intersections, events, sleep and poses. In most worlds no body meets more than one other, so
//! that the order in which the solver gets the contacts cannot matter and everything must be the same to the
//! last bit. Where it does matter (`piles`) only the outcome is compared.

mod questions;
mod strategies;

mod dim2 {
    use flavour::{height_field, hinge, mesh_floor, spin};
    use rapier2d as rapier;
    use unisize::rapier2d_027::{PairFilter, Settings, UnisizeBroadPhase};
    use unisize_scenes::dim2::{Tee, World};

    mod flavour;
    #[path = "../suite/mod.rs"]
    mod suite;
}

mod dim3 {
    use flavour::{height_field, hinge, mesh_floor, spin};
    use rapier3d as rapier;
    use unisize::rapier3d_027::{PairFilter, Settings, UnisizeBroadPhase};
    use unisize_scenes::dim3::{Tee, World};

    mod flavour;
    #[path = "../suite/mod.rs"]
    mod suite;
    mod vehicles;
}

#[path = "dim2"]
mod dim2_f64 {
    use flavour::{height_field, hinge, mesh_floor, spin};
    use rapier2d_f64 as rapier;
    use unisize::rapier2d_f64_027::{PairFilter, Settings, UnisizeBroadPhase};
    use unisize_scenes::dim2_f64::{Tee, World};

    mod flavour;
    #[path = "../suite/mod.rs"]
    mod suite;
}

#[path = "dim3"]
mod dim3_f64 {
    use flavour::{height_field, hinge, mesh_floor, spin};
    use rapier3d_f64 as rapier;
    use unisize::rapier3d_f64_027::{PairFilter, Settings, UnisizeBroadPhase};
    use unisize_scenes::dim3_f64::{Tee, World};

    mod flavour;
    #[path = "../suite/mod.rs"]
    mod suite;
    mod vehicles;
}
