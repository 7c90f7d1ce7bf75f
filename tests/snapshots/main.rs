//! A broad phase that is saved in the middle of a simulation and restored goes on as if nothing had happened: the same
//! events in the same order. And malformed snapshots do no harm.

mod boxes;

#[path = "."]
mod dim2 {
    use rapier2d as rapier;
    use unisize::rapier2d_027::{Kernel, PairFilter, Settings, Stats, UnisizeBroadPhase};
    use unisize_scenes::dim2::{Observed, PairEvent, Scene};

    mod suite;
}

#[path = "."]
mod dim3 {
    use rapier3d as rapier;
    use unisize::rapier3d_027::{Kernel, PairFilter, Settings, Stats, UnisizeBroadPhase};
    use unisize_scenes::dim3::{Observed, PairEvent, Scene};

    mod suite;
}

#[path = "."]
mod dim2_f64 {
    use rapier2d_f64 as rapier;
    use unisize::rapier2d_f64_027::{Kernel, PairFilter, Settings, Stats, UnisizeBroadPhase};
    use unisize_scenes::dim2_f64::{Observed, PairEvent, Scene};

    mod suite;
}

#[path = "."]
mod dim3_f64 {
    use rapier3d_f64 as rapier;
    use unisize::rapier3d_f64_027::{Kernel, PairFilter, Settings, Stats, UnisizeBroadPhase};
    use unisize_scenes::dim3_f64::{Observed, PairEvent, Scene};

    mod suite;
}
