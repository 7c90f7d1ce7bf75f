//! One update of colliders without bodies: Rapier's own broad phase against unisize, on the same frames. The bench `peers` has
//! colliders on bodies.
//!
//! ```text
//! cargo bench --all-features --bench update -- 3D/all-move
//! ```
//!
//! Colliders are drifting cubes of side 1. Moving some of them and listing them as modified is not timed, only the
//! update that follows. In Rapier 0.36 their boxes are handed over, which is timed too. The same colliders move in every frame; they are spread over the whole environment. Reading
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
    use unisize::rapier2d_027 as ours;

    mod dimension;
    #[path = "../common/rapier_027.rs"]
    mod version;
    pub(crate) use dimension::bench;
}

#[path = "update"]
mod dim2_036 {
    use rapier2d_036 as rapier;
    use unisize::rapier2d_036 as ours;

    mod dimension;
    #[path = "../common/rapier_036.rs"]
    mod version;
    pub(crate) use dimension::bench;
}

#[path = "update"]
mod dim3 {
    use rapier3d as rapier;
    use unisize::rapier3d_027 as ours;

    mod dimension;
    #[path = "../common/rapier_027.rs"]
    mod version;
    pub(crate) use dimension::bench;
}

#[path = "update"]
mod dim3_036 {
    use rapier3d_036 as rapier;
    use unisize::rapier3d_036 as ours;

    mod dimension;
    #[path = "../common/rapier_036.rs"]
    mod version;
    pub(crate) use dimension::bench;
}

fn main() {
    let mut criterion = settings::criterion();
    dim2::bench(&mut criterion);
    dim3::bench(&mut criterion);
    dim2_036::bench(&mut criterion);
    dim3_036::bench(&mut criterion);
    criterion.final_summary();
}
