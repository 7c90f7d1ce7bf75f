//! The scene of the paper has the paper's numbers of collisions: |C| in the table of its Figure 3.

use unisize::{Aabb, GridSweep, PairFinder};
use unisize_scenes::DriftingBoxes;

/// Density, and thousands of collisions of 2^17, 2^18, 2^19 and 2^20 squares.
const COLLISIONS: [(f64, [f64; 4]); 4] = [
    (0.2, [53.0, 105.0, 210.0, 420.0]),
    (0.4, [105.0, 210.0, 420.0, 840.0]),
    (0.6, [158.0, 315.0, 631.0, 1260.0]),
    (0.8, [211.0, 421.0, 841.0, 1681.0]),
];

#[test]
fn collisions_are_as_many_as_in_the_paper() {
    let mut finder = GridSweep::default();
    let (mut boxes, mut pairs) = (Vec::new(), Vec::new());
    for (density, row) in COLLISIONS {
        for (size, thousands) in (17..).zip(row) {
            let mut drifting = DriftingBoxes::<2>::new(1 << size, density, 7);
            drifting.advance();
            boxes.clear();
            let unit = |mins: &[f32; 2]| Aabb::new(*mins, mins.map(|x| x + 1.0));
            boxes.extend(drifting.mins().iter().map(unit));
            finder.find_pairs(&boxes, &mut pairs).unwrap();
            // Pairs are nearly independent of each other, so each of the two numbers is nearly Poisson distributed. The
            // paper's is rounded to thousands.
            let expected = thousands * 1e3;
            let allowed = 500.0 + 4.0 * (2.0 * expected).sqrt();
            let found = pairs.len() as f64;
            assert!(
                (found - expected).abs() <= allowed,
                "d = {density}, n = 2^{size}: {found} instead of {expected} ± {allowed:.0}"
            );
        }
    }
}
