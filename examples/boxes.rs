//! Without an engine: which of a million boxes overlap? `GridSweep` takes a slice of boxes and returns their pairs.
//!
//! ```text
//! cargo run --release --example boxes
//! ```
//!
//! Prints how many pairs there are, and how long the search takes on one thread. Fails if the pairs of a part of the boxes are not those of
//! comparing each with each.

use std::time::Instant;

use unisize::{Aabb, BruteForce, GridSweep, InvalidInput, PairFinder};

const BOXES: usize = 1_000_000;
const ROUNDS: usize = 10;

fn main() -> Result<(), InvalidInput> {
    // Cubes of side 1, one in each ten units of volume.
    let half = (10.0 * BOXES as f32).cbrt() / 2.0;
    let mut random = oorandom::Rand32::new(1);
    let mut vector = |most: f32| [(); 3].map(|()| most * (2.0 * random.rand_float() - 1.0));
    let mut centers: Vec<_> = (0..BOXES).map(|_| vector(half)).collect();
    let velocities: Vec<_> = (0..BOXES).map(|_| vector(0.1)).collect();

    // It keeps its memory from call to call, and so does the list of pairs.
    let mut sweep = GridSweep::default();
    let mut pairs = Vec::new();
    let mut boxes = Vec::new();
    let mut least = f64::INFINITY;
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
        least = least.min(start.elapsed().as_secs_f64());
    }
    // Indices of boxes, the smaller one first.
    println!(
        "{BOXES} boxes, {} pairs in {:.1} ms",
        pairs.len(),
        least * 1e3
    );

    let part = &boxes[..5000];
    let mut expected = Vec::new();
    sweep.find_pairs(part, &mut pairs)?;
    BruteForce.find_pairs(part, &mut expected)?;
    pairs.sort_unstable();
    expected.sort_unstable();
    assert!(pairs == expected, "the pairs differ");

    // A box that is inverted or has a NaN is an error that names it.
    boxes[7].mins[0] = f32::NAN;
    let error = sweep.find_pairs(&boxes, &mut pairs).unwrap_err();
    println!("with a NaN in the eighth box: {error}");
    Ok(())
}
