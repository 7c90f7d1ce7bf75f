//! Boxes on which some methods break down: a single frame, without an engine.

use crate::random::Random;

named! {
    /// Arrangements of boxes that make one method or another slow. Most have about 0.8 overlapping pairs a box, as
    /// [`DriftingBoxes`](crate::DriftingBoxes) have at their usual density.
    HardBoxes {
        Uniform "uniform" "Not hard: cubes of side 1, uniform in a cube. The baseline for the others."
        Coincident "all in one place" "Cubes all in one place: any two overlap."
        Clusters "100 clusters 1e6 apart" "100 tight clusters, 10⁶ sides apart."
        Line "line along the first axis" "In a row along the first axis."
        Column "column along the last axis" "In a row along the last axis."
        PlaneAcrossFirst "plane across the first axis" "In a square across the first axis; in 2D the same as a column."
        PlaneAcrossSecond "plane across the second axis" "In a square across the second axis; in 2D the same as a line."
        PlaneAcrossLast "plane across the last axis" "In a square across the last axis."
        Diagonal "diagonal" "Along the diagonal of a cube."
        Needles "needles 1:100" "A hundred times as long as wide, along an axis drawn for each."
        Runaway "one at 1e30" "Uniform, and one of them at 10³⁰."
        OneToFour "sizes 1 to 4" "Sides between 1 and 4."
        FewLarge "one in 100 is 100 times as large" "One cube in a hundred is 100 times as large."
        SixOrders "sizes over six orders" "Sides over six powers of ten."
        FarOut "at 1e7, four ulps wide" "At 10⁷, where a cube of side 4 is four numbers wide."
    }
}

/// Overlapping pairs per box, where all are of one size.
const PAIRS: f64 = 0.8;

const CLUSTERS: usize = 100;
const CLUSTER_DISTANCE: f32 = 1e6;
const NEEDLE: [f32; 2] = [0.1, 10.0];
const FAR: f32 = 1e7;
const FAR_SIDE: f32 = 4.0;

impl HardBoxes {
    /// Whether `count` boxes would have more pairs than a bench can wait for, or a list can hold.
    pub fn are_too_many(self, count: usize) -> bool {
        self == Self::Coincident && count > 1 << 12
    }

    /// The lower and the upper corner of each of `count` boxes. Equal arguments give equal boxes. **O(n)**.
    pub fn boxes<const D: usize>(self, count: usize, seed: u64) -> Vec<[[f32; D]; 2]> {
        let random = &mut Random::new(seed);
        let unit = [1.0; D];
        let mut boxes: Vec<_> = match self {
            Self::Uniform | Self::Runaway => scatter(random, &vec![unit; count], |_| true),
            Self::Coincident => vec![[[0.0; D], unit]; count],
            Self::Clusters => clusters(random, count),
            Self::Line => scatter(random, &vec![unit; count], |k| k == 0),
            Self::Column => scatter(random, &vec![unit; count], |k| k == D - 1),
            Self::PlaneAcrossFirst => scatter(random, &vec![unit; count], |k| k != 0),
            Self::PlaneAcrossSecond => scatter(random, &vec![unit; count], |k| k != 1),
            Self::PlaneAcrossLast => scatter(random, &vec![unit; count], |k| k != D - 1),
            Self::Diagonal => {
                let line = scatter(random, &vec![unit; count], |k| k == 0);
                line.iter()
                    .map(|[mins, _]| cube([mins[0]; D], 1.0))
                    .collect()
            }
            Self::Needles => scatter_drawn(random, count, |random| {
                let mut sides = [NEEDLE[0]; D];
                sides[random.index(D)] = NEEDLE[1];
                sides
            }),
            Self::OneToFour => scatter_drawn(random, count, |random| {
                std::array::from_fn(|_| random.range(1.0, 4.0))
            }),
            Self::FewLarge => scatter_drawn(random, count, |random| {
                [if random.index(100) == 0 { 100.0 } else { 1.0 }; D]
            }),
            Self::SixOrders => scatter_drawn(random, count, |random| {
                [1e-3 * (1e3 / 1e-3_f32).powf(random.range(0.0, 1.0)); D]
            }),
            Self::FarOut => {
                let boxes = scatter(random, &vec![[FAR_SIDE; D]; count], |_| true);
                let corner = |mins: [f32; D]| mins.map(|x| x + FAR);
                boxes
                    .iter()
                    .map(|&[mins, _]| cube(corner(mins), FAR_SIDE))
                    .collect()
            }
        };
        if let (Self::Runaway, Some(last)) = (self, boxes.last_mut()) {
            *last = cube([1e30; D], 1e24);
        }
        boxes
    }
}

/// Boxes whose sides are drawn first, uniform in a cube.
fn scatter_drawn<const D: usize>(
    random: &mut Random,
    count: usize,
    mut sides: impl FnMut(&mut Random) -> [f32; D],
) -> Vec<[[f32; D]; 2]> {
    let sides: Vec<_> = (0..count).map(|_| sides(random)).collect();
    scatter(random, &sides, |_| true)
}

/// Boxes with these sides, uniform along those axes that are `free` and at 0 along the others: as many in the free
/// space as would make [`PAIRS`] pairs a box, were they all of one size.
fn scatter<const D: usize>(
    random: &mut Random,
    sides: &[[f32; D]],
    free: impl Fn(usize) -> bool,
) -> Vec<[[f32; D]; 2]> {
    let axes: Vec<_> = (0..D).filter(|&k| free(k)).collect();
    let volume = |sides: &[f32; D]| axes.iter().map(|&k| f64::from(sides[k])).product::<f64>();
    // Of boxes that fill this part of space, each overlaps 2ᵈ times as many others, and each pair has two.
    let density = PAIRS * 2.0 / f64::from(1 << axes.len());
    let space = sides.iter().map(volume).sum::<f64>() / density;
    let length = space.powf(1.0 / axes.len().max(1) as f64) as f32;
    let place = |sides: &[f32; D]| {
        let mins: [f32; D] = std::array::from_fn(|k| {
            if free(k) {
                random.range(0.0, (length - sides[k]).max(0.0))
            } else {
                0.0
            }
        });
        [mins, std::array::from_fn(|k| mins[k] + sides[k])]
    };
    sides.iter().map(place).collect()
}

/// Clusters on the points of a lattice.
fn clusters<const D: usize>(random: &mut Random, count: usize) -> Vec<[[f32; D]; 2]> {
    let points_a_row = (CLUSTERS as f64).powf(1.0 / D as f64).ceil() as usize;
    let each = count.div_ceil(CLUSTERS);
    let of_cluster = |cluster: usize| {
        let boxes = scatter(random, &vec![[1.0; D]; each], |_| true);
        let corner: [f32; D] = std::array::from_fn(|k| {
            let point = cluster / points_a_row.pow(k as u32) % points_a_row;
            point as f32 * CLUSTER_DISTANCE
        });
        boxes
            .into_iter()
            .map(move |[mins, _]| cube(std::array::from_fn(|k| corner[k] + mins[k]), 1.0))
    };
    (0..CLUSTERS).flat_map(of_cluster).take(count).collect()
}

fn cube<const D: usize>(mins: [f32; D], side: f32) -> [[f32; D]; 2] {
    [mins, mins.map(|x| x + side)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check<const D: usize>(kind: HardBoxes, count: usize) {
        let boxes = kind.boxes::<D>(count, 7);
        assert_eq!(boxes.len(), count, "{kind:?}");
        for [mins, maxs] in boxes {
            assert!((0..D).all(|k| mins[k] < maxs[k]), "{kind:?}: {mins:?}");
        }
    }

    #[test]
    fn boxes_are_valid_and_as_many_as_asked_for() {
        for kind in HardBoxes::ALL {
            for count in [0, 1, 99, 100, 101, 1000] {
                check::<2>(kind, count);
                check::<3>(kind, count);
            }
        }
    }

    #[test]
    fn those_of_one_size_have_about_as_many_pairs_as_said() {
        for kind in HardBoxes::ALL {
            let range = match kind {
                HardBoxes::Coincident => 1999.0..2000.0,
                // Some lie on a shared border, and the diagonal is as long as a line.
                HardBoxes::FarOut => 0.8..2.0,
                HardBoxes::Clusters => 0.4..1.2,
                HardBoxes::OneToFour
                | HardBoxes::FewLarge
                | HardBoxes::SixOrders
                | HardBoxes::Needles => 0.1..200.0,
                _ => 0.7..0.9,
            };
            let boxes = kind.boxes::<3>(4000, 7);
            let overlap = |[a, b]: [&[[f32; 3]; 2]; 2]| {
                (0..3).all(|k| a[0][k] <= b[1][k] && b[0][k] <= a[1][k])
            };
            let pairs: usize = (0..boxes.len())
                .map(|i| (0..i).filter(|&j| overlap([&boxes[i], &boxes[j]])).count())
                .sum();
            let each = pairs as f64 / boxes.len() as f64;
            assert!(range.contains(&each), "{kind:?}: {each} pairs a box");
        }
    }
}
