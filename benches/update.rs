//! `BroadPhase::update` alone: Rapier's own broad phase against this one, on the same frames.
//!
//! ```text
//! cargo bench --all-features --bench update -- 3D/all-move
//! ```
//!
//! Colliders are cubes of side 1 that drift about. Some of them are moved and listed as modified, outside of
//! the timing; then the one update is timed. What moves is always the same part of the colliders, spread
//! over the whole environment. Reading the clock takes some 50 ns and is included, which matters for 10
//! colliders only.

mod common;
#[path = "update/dim2.rs"]
mod dim2;
#[path = "update/dim3.rs"]
mod dim3;

/// What happens to the colliders between two updates.
#[derive(Clone, Copy)]
enum Motion {
    /// One of so many drifts on, and only these are listed.
    OneIn(usize),
    /// All are listed, and none has left the margin around its box.
    InMargin,
}

impl Motion {
    const ALL: [Self; 4] = [
        Self::OneIn(1),
        Self::OneIn(10),
        Self::OneIn(100),
        Self::InMargin,
    ];

    fn name(self) -> String {
        match self {
            Self::OneIn(1) => "all-move".to_owned(),
            Self::OneIn(stride) => format!("one-in-{stride}-moves"),
            Self::InMargin => "all-in-margin".to_owned(),
        }
    }

    /// The distance, in indices, from one listed collider to the next.
    fn stride(self) -> usize {
        match self {
            Self::OneIn(stride) => stride,
            Self::InMargin => 1,
        }
    }
}

fn main() {
    let mut criterion = common::criterion();
    dim2::bench(&mut criterion);
    dim3::bench(&mut criterion);
    criterion.final_summary();
}
