//! Lines that show the pairs of a broad phase and the strips of its grid.

/// A line between two points.
pub(crate) type Line = [[f32; 3]; 2];

/// The most strips of an axis that are drawn: more would be a grey area.
const MOST_STRIPS: u32 = 400;

/// Boxes with a diagonal longer than this many usual ones belong to another class than the one whose grid is drawn.
const OUTSIZE: f32 = 12.0;

/// A box is much larger than another if its diagonal is longer by this factor.
const MUCH_LARGER: f32 = 4.0;

/// A box.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Extent {
    pub(crate) mins: [f32; 3],
    pub(crate) maxs: [f32; 3],
}

impl Extent {
    fn center(&self) -> [f32; 3] {
        std::array::from_fn(|axis| f32::midpoint(self.mins[axis], self.maxs[axis]))
    }

    fn size(&self, axis: usize) -> f32 {
        self.maxs[axis] - self.mins[axis]
    }

    fn diagonal(&self) -> f32 {
        let squares = (0..3).map(|axis| self.size(axis).powi(2));
        squares.sum::<f32>().sqrt()
    }

    fn nearest(&self, point: [f32; 3]) -> [f32; 3] {
        // Not `clamp`, which would panic on an inverted box.
        std::array::from_fn(|axis| point[axis].max(self.mins[axis]).min(self.maxs[axis]))
    }
}

/// The line of a pair, from centre to centre. In a box that is much larger than the other, it ends at the nearest point instead,
/// because the centre may be far away.
pub(crate) fn pair_line(first: &Extent, second: &Extent) -> Line {
    let [a, b] = [first, second].map(Extent::center);
    let [size_a, size_b] = [first, second].map(Extent::diagonal);
    if size_b > MUCH_LARGER * size_a {
        [a, second.nearest(a)]
    } else if size_a > MUCH_LARGER * size_b {
        [first.nearest(b), b]
    } else {
        [a, b]
    }
}

/// The borders between strips, drawn on the far walls of the space as seen from `eye`.
///
/// `strips` is their number along the second and the third axis, 0 where an axis is not cut. The grid itself is not public. It
/// begins before the boxes by a quarter of their spread and is one and a half times as long (see
/// `src/grid_sweep/grid.rs`), and is drawn like that here: the number of strips is exact, the place of a border is an estimate,
/// right to about half a strip.
pub(crate) fn strip_lines(extents: &[Extent], strips: [u32; 2], eye: [f32; 3]) -> Vec<Line> {
    let Some(room) = room(extents) else {
        return Vec::new();
    };
    let wall = std::array::from_fn(|axis| {
        if eye[axis] < room.center()[axis] {
            room.maxs[axis]
        } else {
            room.mins[axis]
        }
    });
    let mut lines = Vec::new();
    let mut draw = |axis: usize, border: f32, along: usize| {
        if room.size(along) == 0.0 {
            return; // In the plane.
        }
        let mut start: [f32; 3] = wall;
        start[axis] = border;
        let mut end = start;
        (start[along], end[along]) = (room.mins[along], room.maxs[along]);
        lines.push([start, end]);
    };
    for (axis, count) in [1, 2].into_iter().zip(strips) {
        let mins: Vec<f32> = extents.iter().map(|extent| extent.mins[axis]).collect();
        for border in borders(mins, count) {
            if room.mins[axis] < border && border < room.maxs[axis] {
                // On the two walls that the border meets: the one along the first axis, and the one across it.
                draw(axis, border, 0);
                draw(axis, border, 3 - axis);
            }
        }
    }
    lines
}

/// The median diagonal, 0 without boxes.
pub(crate) fn usual_size(extents: &[Extent]) -> f32 {
    let mut sizes: Vec<f32> = extents.iter().map(Extent::diagonal).collect();
    quantile(&mut sizes, 0.5).unwrap_or_default()
}

/// The bounds of the boxes of usual sizes, if there are any.
fn room(extents: &[Extent]) -> Option<Extent> {
    let limit = OUTSIZE * usual_size(extents);
    let usual = extents.iter().filter(|extent| extent.diagonal() <= limit);
    usual.copied().reduce(|room, extent| Extent {
        mins: std::array::from_fn(|axis| room.mins[axis].min(extent.mins[axis])),
        maxs: std::array::from_fn(|axis| room.maxs[axis].max(extent.maxs[axis])),
    })
}

/// The borders between `count` strips of an axis on which boxes begin at `mins`.
fn borders(mut mins: Vec<f32>, count: u32) -> Vec<f32> {
    if !(2..=MOST_STRIPS).contains(&count) {
        return Vec::new();
    }
    let (Some(low), Some(high)) = (quantile(&mut mins, 0.02), quantile(&mut mins, 0.98)) else {
        return Vec::new();
    };
    let spread = high - low;
    // The last strip is incomplete: its number is the length over the width, rounded down.
    let width = 1.5 * spread / (count as f32 - 0.5);
    let origin = low - spread / 4.0;
    (1..count)
        .map(|border| origin + border as f32 * width)
        .collect()
}

fn quantile(numbers: &mut [f32], share: f32) -> Option<f32> {
    let index = (numbers.len().checked_sub(1)? as f32 * share) as usize;
    Some(*numbers.select_nth_unstable_by(index, f32::total_cmp).1)
}

#[cfg(test)]
mod tests {
    use super::{Extent, borders, pair_line, strip_lines};

    fn cube(center: [f32; 3], half: f32) -> Extent {
        Extent {
            mins: center.map(|x| x - half),
            maxs: center.map(|x| x + half),
        }
    }

    #[test]
    fn pairs_go_from_centre_to_centre() {
        let (a, b) = (cube([0.0; 3], 1.0), cube([1.0, 0.5, 0.0], 2.0));
        assert_eq!(pair_line(&a, &b), [[0.0; 3], [1.0, 0.5, 0.0]]);
    }

    #[test]
    fn pairs_with_a_floor_end_where_it_is_nearest() {
        let floor = Extent {
            mins: [-50.0, -1.0, -50.0],
            maxs: [50.0, 0.0, 50.0],
        };
        let grain = cube([7.0, 0.5, 3.0], 0.75);
        let expected = [[7.0, 0.5, 3.0], [7.0, 0.0, 3.0]];
        assert_eq!(pair_line(&grain, &floor), expected);
        assert_eq!(pair_line(&floor, &grain), [expected[1], expected[0]]);
    }

    /// 101 cubes in a row along an axis, one unit of length apart.
    fn row(axis: usize) -> Vec<Extent> {
        let place = |i| {
            let mut center = [0.0; 3];
            center[axis] = i as f32;
            cube(center, 0.5)
        };
        (0..=100).map(place).collect()
    }

    #[test]
    fn borders_are_evenly_spread_over_more_than_the_boxes() {
        let mins = (0..=100).map(|i| i as f32).collect();
        let borders = borders(mins, 10);
        assert_eq!(borders.len(), 9);
        let width = 1.5 * 96.0 / 9.5;
        for (number, border) in (1..).zip(&borders) {
            let expected = 2.0 - 24.0 + number as f32 * width;
            assert!((border - expected).abs() < 1e-3, "{border} {expected}");
        }
    }

    #[test]
    fn nothing_is_drawn_that_is_not_cut() {
        let boxes = row(2);
        assert!(strip_lines(&boxes, [0, 0], [0.0; 3]).is_empty());
        assert!(strip_lines(&boxes, [1, 1], [0.0; 3]).is_empty());
        assert!(strip_lines(&boxes, [1, u32::MAX], [0.0; 3]).is_empty());
        assert!(strip_lines(&[], [9, 9], [0.0; 3]).is_empty());
    }

    #[test]
    fn borders_lie_within_the_boxes_and_away_from_the_eye() {
        let mut boxes = row(2);
        boxes.push(cube([0.0; 3], 1e4)); // Not of the class that is drawn.
        let lines = strip_lines(&boxes, [1, 10], [9.0, 9.0, -9.0]);
        assert!(!lines.is_empty() && lines.len() % 2 == 0);
        for [start, end] in lines {
            assert_eq!(start[2], end[2]);
            assert!((-0.5..=100.5).contains(&start[2]));
            if start[0] == end[0] {
                assert_eq!((start[0], start[1], end[1]), (-0.5, -0.5, 0.5));
            } else {
                assert_eq!((start[1], start[0], end[0]), (-0.5, -0.5, 0.5));
            }
        }
    }
}
