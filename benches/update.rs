//! `BroadPhase::update` alone: Rapier's own broad phase against unisize, on the same frames.
//!
//! ```text
//! cargo bench --features rapier2d,rapier3d,parallel --bench update -- 3D/all-move
//! ```
//!
//! Colliders are drifting cubes of side 1. Moving some of them and listing them as modified is not timed, only the
//! update that follows. The same colliders move in every frame; they are spread over the whole environment. Reading
//! the clock takes some 50 ns, which is included and matters for 10 colliders only.

mod common;
#[path = "update/motion.rs"]
mod motion;
#[path = "common/settings.rs"]
mod settings;

use motion::Motion;

#[path = "update"]
mod dim2 {
    use rapier2d as rapier;
    use unisize::rapier2d as ours;

    mod dimension;
    pub(crate) use dimension::bench;
}

#[path = "update"]
mod dim3 {
    use rapier3d as rapier;
    use unisize::rapier3d as ours;

    mod dimension;
    pub(crate) use dimension::bench;
}

fn main() {
    let mut criterion = settings::criterion();
    dim2::bench(&mut criterion);
    dim3::bench(&mut criterion);
    criterion.final_summary();
}
