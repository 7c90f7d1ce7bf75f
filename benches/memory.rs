//! The memory that a broad phase holds, ours and Rapier's own, measured by a counting allocator.
//!
//! ```text
//! cargo bench --all-features --bench memory
//! ```
//!
//! Bytes per collider after the broad phase has followed some frames: what dropping it frees. Events do not count, since
//! they go into the caller's list.

#[path = "common/allocator.rs"]
mod allocator;
mod common;
#[path = "update/motion.rs"]
mod motion;

use allocator::bytes_held;
use motion::Motion;

#[path = "memory"]
mod dim2 {
    use rapier2d as rapier;
    use unisize::rapier2d_027 as ours;

    mod dimension;
    #[path = "../common/rapier_027.rs"]
    mod version;
    pub(crate) use dimension::print;
}

#[path = "memory"]
mod dim2_036 {
    use rapier2d_036 as rapier;
    use unisize::rapier2d_036 as ours;

    mod dimension;
    #[path = "../common/rapier_036.rs"]
    mod version;
    pub(crate) use dimension::print;
}

#[path = "memory"]
mod dim3 {
    use rapier3d as rapier;
    use unisize::rapier3d_027 as ours;

    mod dimension;
    #[path = "../common/rapier_027.rs"]
    mod version;
    pub(crate) use dimension::print;
}

#[path = "memory"]
mod dim3_036 {
    use rapier3d_036 as rapier;
    use unisize::rapier3d_036 as ours;

    mod dimension;
    #[path = "../common/rapier_036.rs"]
    mod version;
    pub(crate) use dimension::print;
}

fn main() {
    common::set_threads();
    println!(
        "| Rapier | dimension | motion | n | pairs | its own, bytes a collider | unisize | aim |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    for motion in Motion::ALL {
        dim2::print(motion);
        dim3::print(motion);
        dim2_036::print(motion);
        dim3_036::print(motion);
    }
}
