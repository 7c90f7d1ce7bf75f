//! Boxes on which some methods become slow: a single frame, without an engine.

use super::random::Random;

named! {
    /// Arrangements of boxes that make one method or another slow. Most have about 0.8 overlapping pairs per box, as `DriftingBoxes` have at
    /// their usual density.
    HardBoxes {
        Uniform "uniform" "Not hard: cubes of side 1, uniform in a cube. The baseline for the others."
        Coincident "all in one place" "Cubes in one place: all overlap."
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
        FourOrders "sizes over four orders" "Sides over four powers of ten."
        WallsAlongFirst "walls along the first axis" "Small cubes between walls as long as the world, one box in eight; no cube touches a wall."
        WallsAlongSecond "walls along the second axis" "The same along the second axis."
        WallsAlongLast "walls along the last axis" "The same along the last axis."
        Specks10 "specks in a gap of 10" "Half of the cubes have side 10 and are spread out; half have side 1 and lie in one gap between them."
        Specks100 "specks in a gap of 100" "The same with side 100."
        Specks1000 "specks in a gap of 1,000" "The same with side 1,000."
        ManySpecks "nine specks in ten, in a gap of 100" "The same with side 100 for one cube in ten."
        Floor "floor of tiles under grains" "Half are flat tiles that touch each other, half are grains a tenth as wide, in a layer above."
        Maze "maze of wall segments" "Walls 1:20:5 along the edges of a lattice, along each axis in turn."
        City "city of towers 1:1:20" "Houses twenty times as high as wide, in streets."
        Lying "the same city, lying on its side" "Houses that are long along the first axis."
        Plates "plates across two axes" "Half are plates across the first axis, half across the second, next to them; no two touch."
        Parked "column, three in 100 at 1e30" "A column along the last axis; three cubes in a hundred are parked far away."
        FarAway "one in 50 is 1e12 away" "Uniform, and one cube in fifty is 10¹² away."
        FarOut "at 1e7, four ulps wide" "At 10⁷, where a cube of side 4 is four representable numbers wide."
    }
}

/// Overlapping pairs per box, if all boxes have the same size.
const PAIRS: f64 = 0.8;

const CLUSTERS: usize = 100;
const CLUSTER_DISTANCE: f32 = 1e6;
const NEEDLE: [f32; 2] = [0.1, 10.0];
const FAR: f32 = 1e7;
const FAR_SIDE: f32 = 4.0;

impl HardBoxes {
    /// Whether `count` boxes would have too many pairs for a bench or a list.
    pub fn are_too_many(self, count: usize) -> bool {
        self == Self::Coincident && count > 1 << 12
    }

    /// The mins and maxs of `count` boxes. Equal arguments give equal boxes. **O(n)**.
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
            Self::FourOrders => scatter_drawn(random, count, |random| {
                [1e4_f32.powf(random.range(0.0, 1.0)); D]
            }),
            Self::WallsAlongFirst => walls(random, count, 0),
            Self::WallsAlongSecond => walls(random, count, 1),
            Self::WallsAlongLast => walls(random, count, D - 1),
            Self::Specks10 => specks(random, count, 10.0, 2),
            Self::Specks100 => specks(random, count, 100.0, 2),
            Self::Specks1000 => specks(random, count, 1000.0, 2),
            Self::ManySpecks => specks(random, count, 100.0, 10),
            Self::Floor => floor(random, count),
            Self::Maze => on_lattice(count, 25.0, |i| {
                let long = i % D;
                std::array::from_fn(|k| match (k + D - long) % D {
                    0 => 20.0,
                    1 => 5.0,
                    _ => 1.0,
                })
            }),
            Self::City => on_lattice(count, 1.5, |_| {
                std::array::from_fn(|k| if k == D - 1 { 20.0 } else { 1.0 })
            }),
            Self::Lying => on_lattice(count, 1.5, |_| {
                std::array::from_fn(|k| if k == 0 { 20.0 } else { 1.0 })
            }),
            Self::Plates => plates(count),
            Self::Parked => {
                let mut boxes = scatter(random, &vec![unit; count], |k| k == D - 1);
                for (i, parked) in boxes.iter_mut().take(count * 3 / 100).enumerate() {
                    *parked = cube([1e30 * (1.0 + i as f32 / count as f32); D], 1e24);
                }
                boxes
            }
            Self::FarAway => {
                let mut boxes = scatter(random, &vec![unit; count], |_| true);
                for far in boxes.iter_mut().take(count / 50) {
                    *far = cube(far[0].map(|x| x + 1e12 * random.range(-1.0, 1.0)), 1e5);
                }
                boxes
            }
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

/// Boxes uniform in a cube. Their sides are drawn first.
fn scatter_drawn<const D: usize>(
    random: &mut Random,
    count: usize,
    mut sides: impl FnMut(&mut Random) -> [f32; D],
) -> Vec<[[f32; D]; 2]> {
    let sides: Vec<_> = (0..count).map(|_| sides(random)).collect();
    scatter(random, &sides, |_| true)
}

/// Boxes with these sides, uniform along the axes that are `free` and at 0 along the others. Their density would give [`PAIRS`] pairs per box
/// if all had the same size.
fn scatter<const D: usize>(
    random: &mut Random,
    sides: &[[f32; D]],
    free: impl Fn(usize) -> bool,
) -> Vec<[[f32; D]; 2]> {
    let axes: Vec<_> = (0..D).filter(|&k| free(k)).collect();
    let volume = |sides: &[f32; D]| axes.iter().map(|&k| f64::from(sides[k])).product::<f64>();
    // If boxes fill a share of space, each overlaps 2ᵈ times that share of others, and each pair has two boxes.
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

/// Cubes in the cells of a lattice. One box in eight is a wall on the faces of the cells, as long as the world along an axis.
fn walls<const D: usize>(random: &mut Random, count: usize, along: usize) -> Vec<[[f32; D]; 2]> {
    let length = (5.0 * count as f32).powf(1.0 / D as f32);
    let along = along.min(D - 1);
    let mut draw = |i: usize| {
        let mut mins: [f32; D] = std::array::from_fn(|_| random.range(0.0, length).floor());
        let mut maxs = mins.map(|x| x + 0.125);
        if i % 8 == 7 {
            (mins[along], maxs[along]) = (0.0, length + 1.0);
            return [mins, maxs];
        }
        cube(mins.map(|x| x + 0.25), 0.5)
    };
    (0..count).map(&mut draw).collect()
}

/// Large cubes, spread out on a lattice, and cubes of side 1, which lie densely in one of its gaps.
fn specks<const D: usize>(
    random: &mut Random,
    count: usize,
    side: f32,
    one_in: usize,
) -> Vec<[[f32; D]; 2]> {
    let large = count / one_in;
    let mut boxes = on_lattice(large, 2.0, |_| [side; D]);
    let small = scatter(random, &vec![[1.0; D]; count - large], |_| true);
    // The small cubes fit into the gap, if necessary with a smaller side.
    let space = small
        .iter()
        .flat_map(|[_, maxs]| maxs)
        .fold(0.0, |a, &b| f32::max(a, b));
    let scale = f32::min(1.0, 0.9 * side / space);
    let place = |x: f32| 1.05 * side + scale * x;
    boxes.extend(small.iter().map(|b| b.map(|corner| corner.map(place))));
    boxes
}

/// Tiles of 10:10:1 in a plane across the last axis, and as many grains of side 1 in a layer above it.
fn floor<const D: usize>(random: &mut Random, count: usize) -> Vec<[[f32; D]; 2]> {
    let row = (count as f32 / 2.0)
        .powf(1.0 / (D - 1).max(1) as f32)
        .ceil() as usize;
    let tile = |i: usize| {
        let mins: [f32; D] = std::array::from_fn(|k| match k == D - 1 {
            true => -1.0,
            false => 10.0 * (i / row.pow(k as u32) % row) as f32,
        });
        [
            mins,
            std::array::from_fn(|k| mins[k] + if k == D - 1 { 1.0 } else { 10.0 }),
        ]
    };
    let mut boxes: Vec<_> = (0..count / 2).map(tile).collect();
    let mut grain = || {
        cube(
            std::array::from_fn(|k| match k == D - 1 {
                true => random.range(0.5, 3.0),
                false => random.range(0.0, 10.0 * row as f32),
            }),
            1.0,
        )
    };
    boxes.extend((count / 2..count).map(|_| grain()));
    boxes
}

/// Boxes with these sides at the points of a lattice. Its spacing along each axis is a multiple of the longest side along that axis; above 1,
/// boxes do not overlap.
fn on_lattice<const D: usize>(
    count: usize,
    spacing: f32,
    sides: impl Fn(usize) -> [f32; D],
) -> Vec<[[f32; D]; 2]> {
    let row = (count as f32).powf(1.0 / D as f32).ceil().max(1.0) as usize;
    let one = sides(0);
    let is_alike = (0..D).all(|i| sides(i) == one);
    let at = |i: usize| {
        let sides = sides(i);
        let mins: [f32; D] = std::array::from_fn(|k| {
            let step = if is_alike { spacing * one[k] } else { spacing };
            step * (i / row.pow(k as u32) % row) as f32
        });
        [mins, std::array::from_fn(|k| mins[k] + sides[k])]
    };
    (0..count).map(at).collect()
}

/// Plates across the first axis, and plates across the second next to them. No two touch.
fn plates<const D: usize>(count: usize) -> Vec<[[f32; D]; 2]> {
    let length = 3.0 * count as f32;
    let at = |i: usize| {
        let (across, others) = match i % 2 {
            0 => (0, 0.0),
            _ => (1, -length - 10.0),
        };
        let place = 3.0 * (i / 2) as f32;
        let from = |k: usize, at: [f32; 2]| if k == across { at[0] } else { at[1] };
        let mins = std::array::from_fn(|k| from(k, [place, others]));
        let maxs = std::array::from_fn(|k| from(k, [place + 1.0, others + length]));
        [mins, maxs]
    };
    (0..count).map(at).collect()
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
    fn boxes_are_valid_and_have_the_right_number() {
        for kind in HardBoxes::ALL {
            for count in [0, 1, 99, 100, 101, 1000] {
                check::<2>(kind, count);
                check::<3>(kind, count);
            }
        }
    }

    #[test]
    fn boxes_of_one_size_have_the_expected_number_of_pairs() {
        for kind in HardBoxes::ALL {
            let range = match kind {
                HardBoxes::Coincident => 1999.0..2000.0,
                // Rounded boxes share borders.
                HardBoxes::FarOut => 0.8..2.0,
                HardBoxes::Clusters => 0.4..1.2,
                HardBoxes::Uniform
                | HardBoxes::Line
                | HardBoxes::Column
                | HardBoxes::PlaneAcrossFirst
                | HardBoxes::PlaneAcrossSecond
                | HardBoxes::PlaneAcrossLast
                | HardBoxes::Diagonal
                | HardBoxes::Runaway => 0.7..0.9,
                // Boxes of several sizes.
                _ => 0.0..200.0,
            };
            let boxes = kind.boxes::<3>(4000, 7);
            let overlap = |[a, b]: [&[[f32; 3]; 2]; 2]| {
                (0..3).all(|k| a[0][k] <= b[1][k] && b[0][k] <= a[1][k])
            };
            let pairs: usize = (0..boxes.len())
                .map(|i| (0..i).filter(|&j| overlap([&boxes[i], &boxes[j]])).count())
                .sum();
            let each = pairs as f64 / boxes.len() as f64;
            assert!(range.contains(&each), "{kind:?}: {each} pairs per box");
        }
    }
}
