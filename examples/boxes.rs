//! Without an engine: which of a million boxes overlap? `GridSweep` takes a slice of boxes and returns their pairs.
//!
//! ```text
//! cargo run --release --example boxes
//! ```
//!
//! Prints the number of pairs, and the time of a search on one thread. Fails if brute force finds other pairs among a part of the boxes.

use std::time::Instant;

use unisize::{Aabb, BruteForce, GridSweep, InvalidInput, PairFinder};

const BOXES: usize = 1_000_000;
const ROUNDS: usize = 10;

fn main() -> Result<(), InvalidInput> {
    // Cubes of side 1 that fill a tenth of space.
    let half = (10.0 * BOXES as f32).cbrt() / 2.0;
    let mut random = oorandom::Rand32::new(1);
    let mut vector = |limit: f32| [(); 3].map(|()| limit * (2.0 * random.rand_float() - 1.0));
    let mut centers: Vec<_> = (0..BOXES).map(|_| vector(half)).collect();
    let velocities: Vec<_> = (0..BOXES).map(|_| vector(0.1)).collect();

    // The kernel and the list of pairs keep their memory from call to call.
    let mut sweep = GridSweep::default();
    let mut pairs = Vec::new();
    let mut boxes = Vec::new();
    let mut fastest = f64::INFINITY;
    for _ in 0..ROUNDS {
        for (center, velocity) in centers.iter_mut().zip(&velocities) {
            for axis in 0..3 {
                center[axis] += velocity[axis];
            }
        }
        boxes.clear();
        let mins = centers.iter().map(|center| center.map(|x| x - 0.5));
        boxes.extend(mins.map(|mins| Aabb::new(mins, mins.map(|x| x + 1.0))));

        let start = Instant::now();
        sweep.find_pairs(&boxes, &mut pairs)?;
        fastest = fastest.min(start.elapsed().as_secs_f64());
    }
    // Each pair has the indices of two boxes, the smaller one first.
    println!(
        "{BOXES} boxes, {} pairs in {:.1} ms",
        pairs.len(),
        fastest * 1e3
    );

    let part = &boxes[..5000];
    let mut expected = Vec::new();
    sweep.find_pairs(part, &mut pairs)?;
    BruteForce.find_pairs(part, &mut expected)?;
    pairs.sort_unstable();
    expected.sort_unstable();
    assert!(pairs == expected, "the pairs differ");

    // An inverted box, or one with a NaN, is an error that has its index.
    boxes[7].mins[0] = f32::NAN;
    let error = sweep.find_pairs(&boxes, &mut pairs).unwrap_err();
    println!("with a NaN in box 7: {error}");
    assert_eq!(error.index, 7);
    Ok(())
}
