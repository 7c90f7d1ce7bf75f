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

/// The worst mixtures of several searches for hard boxes, by the numbers of their populations.
const FOUND: [[[f32; 9]; 3]; 9] = [
    [
        [
            0.8673, 0.6206, 0.4166, 0.5447, 0.5024, 0.9813, 0.7836, 0.9483, 0.7193,
        ],
        [
            0.5389, 1.0, 0.5038, 0.8312, 0.0873, 0.9537, 0.3312, 0.0635, 0.9620,
        ],
        [
            0.6810, 0.4988, 0.7839, 1.0, 0.7490, 0.9413, 0.1802, 0.4863, 0.1081,
        ],
    ],
    [
        [
            0.5417, 0.8855, 0.7212, 0.4962, 1.0, 1.0, 0.1477, 0.6089, 0.4981,
        ],
        [
            0.5464, 0.2265, 0.4578, 0.3775, 0.0, 1.0, 0.4963, 0.6179, 0.3104,
        ],
        [
            0.3483, 0.6227, 0.7795, 0.3664, 0.0564, 0.9061, 0.3565, 0.6505, 0.6865,
        ],
    ],
    [
        [
            0.7125, 0.2503, 0.4183, 0.9315, 0.7522, 0.6116, 0.4392, 0.3582, 0.2646,
        ],
        [
            0.7599, 0.5727, 0.7323, 0.2044, 0.1357, 1.0, 0.0976, 0.4336, 0.2836,
        ],
        [
            0.6792, 0.0, 0.2187, 0.2893, 0.6370, 0.1697, 0.0921, 0.3221, 0.6689,
        ],
    ],
    [
        [
            0.6242, 0.6098, 0.5246, 0.9197, 0.4442, 0.8612, 0.1783, 0.3784, 0.0344,
        ],
        [
            0.9045, 0.2229, 0.1125, 0.2049, 0.2577, 1.0, 0.2017, 0.1056, 0.3335,
        ],
        [
            0.1128, 0.1502, 0.2654, 0.5968, 0.6595, 0.4633, 0.0913, 0.3694, 0.9058,
        ],
    ],
    [
        [
            0.3134, 0.5383, 0.1774, 0.9588, 0.4020, 1.0, 0.9266, 0.2530, 0.4746,
        ],
        [
            0.1097, 0.3787, 0.5810, 0.2643, 0.5885, 1.0, 0.4924, 0.7828, 0.1099,
        ],
        [
            0.1128, 0.4711, 0.0296, 0.9830, 0.3340, 0.6700, 0.6628, 0.5311, 0.7522,
        ],
    ],
    [
        [
            0.4679, 0.0518, 0.0333, 0.1113, 0.9432, 0.5884, 0.1147, 0.5657, 0.7780,
        ],
        [
            0.4661, 0.3117, 0.0768, 1.0, 0.1140, 0.8856, 0.7546, 0.9596, 0.1230,
        ],
        [
            0.4226, 0.3099, 0.5016, 0.6659, 0.1224, 0.7894, 0.3096, 0.7582, 0.9783,
        ],
    ],
    [
        [
            0.9966, 0.8672, 0.1663, 0.7916, 0.2263, 1.0, 0.0117, 0.5739, 0.7055,
        ],
        [
            0.8365, 0.3478, 0.0830, 0.2216, 0.0993, 1.0, 0.3962, 0.4549, 0.2097,
        ],
        [
            0.7997, 0.3056, 0.1198, 0.7091, 0.7682, 0.8830, 0.1996, 0.6408, 0.5503,
        ],
    ],
    [
        [
            0.6000, 0.3201, 0.0017, 0.7624, 0.0696, 0.6624, 0.8894, 0.6625, 0.1902,
        ],
        [
            0.4955, 0.9424, 0.4919, 0.8032, 0.2377, 1.0, 0.1143, 0.8797, 0.8182,
        ],
        [
            0.4673, 0.6827, 0.5227, 1.0, 0.7486, 0.9190, 0.1898, 0.5119, 0.0603,
        ],
    ],
    [
        [
            0.3479, 0.0368, 0.1052, 0.2787, 0.2344, 0.9626, 0.2167, 0.3522, 0.0886,
        ],
        [
            0.8699, 0.0190, 0.0, 0.2496, 0.4263, 0.5850, 0.3111, 0.1956, 0.7217,
        ],
        [
            0.9077, 0.7086, 0.5877, 0.6946, 0.3083, 1.0, 0.0924, 0.9571, 0.2019,
        ],
    ],
];

#[test]
fn effort_grows_linearly_for_the_worst_known_mixtures() {
    for (i, populations) in FOUND.into_iter().enumerate() {
        let mixture = Mixture::new(populations);
        let name = format!("mixture {i}");
        // The best way to search a mixture may be another one with more boxes.
        check::<2>(&name, BOUND / 4.0, |count| mixture.boxes(count, 7));
        check::<3>(&name, BOUND / 4.0, |count| mixture.boxes(count, 7));
    }
}
