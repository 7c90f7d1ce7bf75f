//! The effort of `GridSweep` grows with boxes and pairs. It is counted in comparisons, so the tests need no clock.

use crate::arrangements::{HardBoxes, Mixture};
use unisize::{Aabb, GridSweep, PairFinder};

/// The limit of comparisons and visited tubes per box and pair.
const BOUND: f64 = 400.0;

/// The limit of growth per box and pair with four times as many boxes, above a number of comparisons: more tubes may be crowded, and a tree
/// of grids may be one level deeper.
const GROWTH: f64 = 3.0;

/// Comparisons per box and pair, with the axes rotated `turns` times.
fn effort<const D: usize>(boxes: &[[[f32; D]; 2]], turns: usize) -> f64 {
    let turned = |corner: &[f32; D]| std::array::from_fn(|k| corner[(k + turns) % D]);
    let boxes: Vec<Aabb<f32, D>> = boxes
        .iter()
        .map(|[mins, maxs]| Aabb::new(turned(mins), turned(maxs)))
        .collect();
    let (mut kernel, mut pairs) = (GridSweep::default(), Vec::new());
    assert_eq!(kernel.find_pairs(&boxes, &mut pairs), Ok(()));
    kernel.compared() as f64 / (boxes.len() + pairs.len()) as f64
}

fn check<const D: usize>(name: &str, least: f64, boxes: impl Fn(usize) -> Vec<[[f32; D]; 2]>) {
    for turns in 0..D {
        let [few, many] = [1 << 12, 1 << 14].map(|count| effort(&boxes(count), turns));
        assert!(
            many < BOUND && many < GROWTH * few.max(least),
            "{name} in {D}D, turned {turns} times: {few}, {many}"
        );
    }
}

#[test]
fn effort_grows_with_boxes_and_pairs() {
    for kind in HardBoxes::ALL {
        // Coincident boxes have a quadratic number of pairs.
        if kind != HardBoxes::Coincident {
            check::<2>(kind.name(), 16.0, |count| kind.boxes(count, 7));
            check::<3>(kind.name(), 16.0, |count| kind.boxes(count, 7));
        }
    }
}

#[test]
fn effort_grows_linearly_for_the_worst_known_mixtures() {
    for (i, mixture) in Mixture::WORST.iter().enumerate() {
        let name = format!("mixture {}", i + 1);
        // The best way to search a mixture may be another one with more boxes.
        check::<2>(&name, BOUND / 4.0, |count| mixture.boxes(count, 7));
        check::<3>(&name, BOUND / 4.0, |count| mixture.boxes(count, 7));
    }
}
