//! The same events in the same order, with any number of threads.

#[path = "."]
mod dim2 {
    use rapier2d as rapier;
    use unisize::rapier2d_027::{Stats, UnisizeBroadPhase};
    use unisize_scenes::dim2::PairEvent;

    mod suite;
}

#[path = "."]
mod dim3 {
    use rapier3d as rapier;
    use unisize::rapier3d_027::{Stats, UnisizeBroadPhase};
    use unisize_scenes::dim3::PairEvent;

    mod suite;
}

#[path = "."]
mod dim2_f64 {
    use rapier2d_f64 as rapier;
    use unisize::rapier2d_f64_027::{Stats, UnisizeBroadPhase};
    use unisize_scenes::dim2_f64::PairEvent;

    mod suite;
}

#[path = "."]
mod dim3_f64 {
    use rapier3d_f64 as rapier;
    use unisize::rapier3d_f64_027::{Stats, UnisizeBroadPhase};
    use unisize_scenes::dim3_f64::PairEvent;

    mod suite;
}
