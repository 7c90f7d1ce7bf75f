//! Which tube a coordinate belongs to.
//!
//! The axes after the first are cut into strips of equal width; a *tube* is a strip in two dimensions, and the crossing
//! of two strips in three. Whatever the origin and the width are, the strip number is a non-decreasing function of the
//! coordinate, and that alone makes the sweep exact: two overlapping boxes both reach the strip that holds the larger of
//! their two `mins`. So origin and width may be guessed from a sample, and the guess may be wrong.
//!
//! There are more strips than anybody could count, so tubes are numbered modulo a power of two that is about as large as the number of
//! boxes. Tubes with the same number lie far apart, and share a place: what they hold is swept together, but never overlaps.

use crate::aabb::Aabb;
use crate::lanes::Lanes;
use crate::real::Real;

/// One axis, cut into strips.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Strips<R> {
    origin: R,
    per_length: R,
}

/// How many strips there are before the middle of a sample. In single precision, numbers of this size have four bits left for
/// a part of a strip.
const STRIPS_BEFORE: u32 = 1 << 20;

/// The number of the last strip, which takes all farther coordinates. The first one, 0, takes all nearer ones.
const LAST_STRIP: u32 = 1 << 31;

impl<R: Real> Strips<R> {
    /// Strips of this width around the middle of a sample.
    pub(super) fn new(middle: f64, width: f64) -> Self {
        let origin = R::from_f64(middle - f64::from(STRIPS_BEFORE) * width);
        Self {
            origin: if origin.is_finite() { origin } else { R::ZERO },
            per_length: R::from_f64(1.0 / width),
        }
    }

    /// How many strips a coordinate lies beyond the origin. Non-decreasing as long as `origin` is finite and `per_length` not
    /// negative: subtraction and multiplication round monotonically, and so does [`Lanes::truncated`]. 0 · ∞ is NaN and becomes
    /// strip 0: negative offsets are in strip 0 too, positive ones in the last.
    #[inline(always)]
    fn offset(&self, coordinate: R) -> R {
        (coordinate - self.origin) * self.per_length
    }
}

/// The strips of the axes that are cut: the second, and in three dimensions the third. By default there is one tube.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grid<R> {
    pub(super) axes: [Strips<R>; 2],
    /// How long a box may be along the first axis, if that matters. One that is longer would make windows long for all that are looked up
    /// in its tube.
    pub(super) longest: Option<R>,
    /// By how much the numbers of two tubes differ that are next to each other along the first cut axis, if there are two.
    stride: u32,
    /// The number of tubes, a power of two, less one.
    mask: u32,
    /// Boxes that begin more than this many strips beyond the first one, or before, cannot be told apart by strips.
    farthest: u32,
}

impl<R: Default> Default for Grid<R> {
    fn default() -> Self {
        Self {
            axes: Default::default(),
            longest: None,
            stride: 1,
            mask: 0,
            farthest: u32::MAX,
        }
    }
}

/// The tubes that a box spans: from `first` to `last` in each cut axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct TubeSpan {
    pub(super) first: [u32; 2],
    pub(super) last: [u32; 2],
}

impl TubeSpan {
    /// Whether a tube in these strips is one of them.
    #[inline(always)]
    pub(super) fn contains(&self, strips: [u32; 2]) -> bool {
        let is_within = |cut: usize| (self.first[cut]..=self.last[cut]).contains(&strips[cut]);
        is_within(0) & is_within(1)
    }

    /// How many tubes these are.
    pub(super) fn count(&self) -> u64 {
        let [rows, columns] = self.beyond().map(|beyond| u64::from(beyond) + 1);
        rows * columns
    }

    /// How many strips a box spans besides the first. Inverted boxes, which are refused later, wrap around to large numbers.
    #[inline(always)]
    pub(super) fn beyond(&self) -> [u32; 2] {
        [0, 1].map(|cut| self.last[cut].wrapping_sub(self.first[cut]))
    }
}

/// Two boxes that overlap, each at most two strips wide, lie in tubes that are this far apart at most, along either axis.
const REACH: u64 = 2;

impl<R: Real> Grid<R> {
    /// Numbers the tubes, given how many strips most of `count` boxes lie in, along each of the cut axes.
    ///
    /// No two tubes that boxes which overlap can span have the same number.
    pub(super) fn number_tubes<const D: usize>(&mut self, strips: [u64; 2], count: usize) {
        // So that a table of them does not cost more than the boxes do.
        let most = (count as u64).next_power_of_two().clamp(64, 1 << 29);
        let [rows, columns] = strips;
        let tubes = match cut_axes::<D>() {
            0 => return,
            1 => {
                self.stride = 1;
                rows.clamp(2 * REACH, most)
            }
            _ => {
                // One row after the other, if there is room: two columns more, for what lies beside them.
                let stride = columns.saturating_add(2).max(2 * REACH + 1);
                let tubes = stride.saturating_mul(rows.max(REACH + 1));
                let fits = tubes <= most;
                self.stride = match fits {
                    true => stride as u32,
                    // Otherwise rows begin as far from each other as they can: at multiples of the golden ratio.
                    false => (most as f64 * 0.618_034) as u32 | 1,
                };
                tubes.min(most)
            }
        };
        self.mask = (tubes.next_power_of_two() - 1) as u32;
        self.farthest = LAST_STRIP - 2;
    }

    /// How many tubes have a number.
    pub(super) fn tube_count(&self) -> u32 {
        self.mask + 1
    }

    /// The number of the tube in these strips.
    #[inline(always)]
    pub(super) fn tube(&self, [row, column]: [u32; 2]) -> u32 {
        row.wrapping_mul(self.stride).wrapping_add(column) & self.mask
    }

    /// Whether no two tubes of a span have the same number.
    pub(super) fn tells_apart(&self, span: &TubeSpan) -> bool {
        let [rows, columns] = span.beyond().map(u64::from);
        let stride = u64::from(self.stride);
        columns < stride && rows * stride + columns <= u64::from(self.mask)
    }

    /// The strips of a tube of this number in a span in which no two have the same number, and whose first strips are these.
    #[inline(always)]
    pub(super) fn strips(&self, tube: u32, first: [u32; 2]) -> [u32; 2] {
        let offset = tube.wrapping_sub(self.tube(first)) & self.mask;
        [
            first[0] + offset / self.stride,
            first[1] + offset % self.stride,
        ]
    }

    /// The numbers of the tubes that follow one along the first cut axis, along the second, and along both.
    #[inline(always)]
    pub(super) fn next_tubes(&self, tube: u32) -> [u32; 3] {
        [self.stride, 1, self.stride + 1].map(|step| tube.wrapping_add(step) & self.mask)
    }

    /// Whether a box that spans these tubes is more than two strips wide on some axis, too long, or so far away that no strip is told
    /// from the next: such boxes are treated apart.
    #[inline(always)]
    pub(super) fn is_oversized<const D: usize>(&self, aabb: &Aabb<R, D>, span: &TubeSpan) -> bool {
        let [rows, columns] = span.beyond();
        let length = aabb.maxs[0] - aabb.mins[0];
        let is_long = self.longest.is_some_and(|longest| length > longest);
        let mut is_far = false;
        for cut in 0..cut_axes::<D>() {
            // The first strip as well: zero less one is the greatest number.
            is_far |= span.first[cut].wrapping_sub(1) > self.farthest;
        }
        ((rows | columns) > 1) | is_long | is_far
    }

    /// The tubes that a box spans; for an invalid one, any.
    #[inline(always)]
    pub(super) fn tube_span<const D: usize>(&self, aabb: &Aabb<R, D>) -> TubeSpan {
        let mut span = TubeSpan {
            first: [0; 2],
            last: [0; 2],
        };
        let cuts = cut_axes::<D>();
        if cuts == 0 {
            return span;
        }
        // All four lanes hold a sound offset: what the compiler puts into a lane that nobody reads may be a subnormal number,
        // with which the processor calculates a hundred times slower.
        let offset = |corner: &[R; D], cut: usize| {
            let cut = cut.min(cuts - 1);
            self.axes[cut].offset(corner[cut + 1])
        };
        let Aabb { mins, maxs } = aabb;
        let strips = R::Lanes::truncated([
            offset(mins, 0),
            offset(mins, 1),
            offset(maxs, 0),
            offset(maxs, 1),
        ]);
        span.first[..cuts].copy_from_slice(&strips[..cuts]);
        span.last[..cuts].copy_from_slice(&strips[2..2 + cuts]);
        span
    }
}

/// How many axes are cut in `D` dimensions.
#[inline(always)]
pub(super) const fn cut_axes<const D: usize>() -> usize {
    match D {
        0 | 1 => 0,
        2 => 1,
        _ => 2,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tubes_that_overlapping_boxes_span_have_different_numbers() {
        for count in [25, 63, 64, 65, 1000, 4096, 5000, 1 << 20] {
            for rows in [1, 2, 3, 4, 5, 31, 64, 1023, 1 << 20] {
                let mut grid = Grid::<f32>::default();
                grid.number_tubes::<2>([rows, 1], count);
                check(&grid, 0);
                for columns in [1, 2, 3, 4, 5, 63, 64, 1023, 1024, 1025, 1 << 20] {
                    let mut grid = Grid::<f32>::default();
                    grid.number_tubes::<3>([rows, columns], count);
                    assert!(u64::from(grid.tube_count()) <= 2 * count.max(64) as u64);
                    check(&grid, REACH as i32);
                }
            }
        }
    }

    fn check(grid: &Grid<f32>, columns: i32) {
        let rows = REACH as i32;
        for row in -rows..=rows {
            for column in -columns..=columns {
                let [number, other] = [[0, 0], [row, column]]
                    .map(|[r, c]| grid.tube([1000 + r, 2000 + c].map(|strip: i32| strip as u32)));
                assert_eq!(number == other, [row, column] == [0, 0], "{grid:?}");
            }
        }
        let span = TubeSpan {
            first: [1000, 2000],
            last: [1002, 2000 + columns as u32],
        };
        if grid.tells_apart(&span) {
            for row in 1000..=1002 {
                for column in 2000..=span.last[1] {
                    let strips = [row, column];
                    assert_eq!(grid.strips(grid.tube(strips), span.first), strips);
                }
            }
        }
        let [row, column, both] = grid.next_tubes(grid.tube([7, 8]));
        assert_eq!(row, grid.tube([8, 8]));
        if columns > 0 {
            assert_eq!([column, both], [grid.tube([7, 9]), grid.tube([8, 9])]);
        }
    }
}
