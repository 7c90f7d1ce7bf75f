//! How much the suite compares, for `docs/testing.md`:
//! `cargo test --all-features --test oracle census -- --nocapture`.

use crate::check::expected_pairs;
use crate::inputs::{self, Input};

/// Counts the lists, boxes and pairs of one instantiation's inputs.
fn count<const D: usize>() {
    let inputs = inputs::all::<f64, D>();
    let boxes: usize = inputs.iter().map(|input| input.boxes.len()).sum();
    let pairs_of = |input: &Input<f64, D>| expected_pairs(&input.boxes).len();
    let pairs: usize = inputs.iter().map(pairs_of).sum();
    println!(
        "{D}D: {} lists of {boxes} boxes with {pairs} pairs",
        inputs.len()
    );
    // A suite of lists without pairs would test nothing.
    assert!(inputs.len() > 100 && boxes > 30_000 && pairs > boxes);
}

#[test]
fn census_of_inputs() {
    count::<1>();
    count::<2>();
    count::<3>();
    count::<4>();
}
