//! A short run of the study `soak`: many updates of worlds in which everything changes, in the same memory.
//!
//! The study makes a million: `cargo run --release --all-features --example study -- soak`.

use crate::memory::Peaks;
use crate::{dim2, dim3, turn};

const UPDATES: u64 = 20_000;

const COLLIDERS: usize = 200;

const CHECK_EVERY: u64 = 50;

#[test]
fn memory_does_not_grow() {
    let _turn = turn();
    let (mut flat, mut solid) = (dim2::Soak::new(COLLIDERS, 7), dim3::Soak::new(COLLIDERS, 7));
    let mut peaks = Peaks::default();
    for done in 1..=UPDATES {
        flat.update();
        solid.update();
        peaks.note(done, UPDATES);
        if done % CHECK_EVERY == 0 {
            flat.check();
            solid.check();
        }
    }
    assert!(flat.pairs() > 0 && solid.pairs() > 0);
    assert!(peaks.are_flat(), "{peaks:?}");
}
