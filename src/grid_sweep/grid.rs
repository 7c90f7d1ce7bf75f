//! The map from coordinates to tubes.
//!
//! The axes after the first are cut into strips of equal width. A *tube* is a strip in two dimensions, and the crossing of two strips
//! in three. For any origin and width, the number of the strip is a non-decreasing function of the coordinate, and that alone makes
//! the sweep exact: two overlapping boxes both reach the strip that holds the larger of their two `mins`. So a sample may guess
//! origin and width, and the guess may be wrong.
//!
//! There may be any number of strips, so tubes are numbered modulo a power of two, about as large as the number of boxes. Tubes with
//! the same number are swept together, but lie so far apart that their boxes do not overlap.

use super::entry::{MAX_ENTRIES, Owner, Placed};
use crate::aabb::Aabb;
use crate::lanes::Lanes;
use crate::real::Real;

/// One axis, cut into strips.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Strips<R> {
    origin: R,
    per_length: R,
}

/// The number of strips before the middle of the sample. In single precision, numbers of this size leave three bits for a fraction of a strip.
const STRIPS_BEFORE: u32 = 1 << 20;

/// The number of the last strip, which takes all larger coordinates. Strip 0 takes all smaller ones.
const LAST_STRIP: u32 = 1 << 31;

impl<R: Real> Strips<R> {
    /// Strips of this width around the middle of a sample; a single one if they would be too wide to count.
    pub(super) fn new(middle: f64, width: f64) -> Self {
        let origin = R::from_f64(middle - f64::from(STRIPS_BEFORE) * width);
        let per_length = R::from_f64(1.0 / width);
        match origin.is_finite() {
            true => Self { origin, per_length },
            false => Self::default(),
        }
    }
}

/// The strips of the second axis and, in three dimensions, of the third. By default there is one tube.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Grid<R> {
    pub(super) axes: [Strips<R>; 2],
    /// The greatest length of a box along the first axis, if it is limited. One long box lengthens the windows of all look-ups in its tube.
    pub(super) longest: Option<R>,
    /// The difference between the numbers of two successive tubes along the first cut axis, if two axes are cut.
    stride: u32,
    /// The number of tubes, a power of two, less one.
    mask: u32,
}

/// The tubes that a box reaches: from `first` to `last` on each cut axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct TubeSpan {
    pub(super) first: [u32; 2],
    pub(super) last: [u32; 2],
}

impl TubeSpan {
    #[inline(always)]
    pub(super) fn contains(&self, strips: [u32; 2]) -> bool {
        let is_within = |cut: usize| (self.first[cut]..=self.last[cut]).contains(&strips[cut]);
        is_within(0) & is_within(1)
    }

    /// How many strips the box reaches besides the first. Inverted boxes, which no class takes, wrap around to large numbers.
    #[inline(always)]
    pub(super) fn beyond(&self) -> [u32; 2] {
        [0, 1].map(|cut| self.last[cut].wrapping_sub(self.first[cut]))
    }
}

/// Tubes that are at most so many strips apart on each axis have different numbers. Two overlapping boxes, each at most two strips
/// wide, reach no others, and the boxes of a tube lie within as many strips.
pub(super) const REACH: u64 = 2;

impl<R: Real> Grid<R> {
    /// Numbers the tubes for `count` boxes, most of which lie in this many strips on each cut axis. Tubes that two overlapping boxes
    /// can reach get different numbers.
    pub(super) fn number_tubes(&mut self, cuts: usize, [rows, columns]: [u64; 2], count: usize) {
        // A table of the tubes must not cost more than the boxes do.
        let most = (count as u64).next_power_of_two().clamp(64, 1 << 29);
        // One row after the other if they fit, with two columns more for boxes outside.
        let stride = columns.saturating_add(2).max(2 * REACH + 1);
        let (stride, tubes) = match stride.saturating_mul(rows.max(REACH + 1)) {
            _ if cuts < 2 => (1, rows.clamp(2 * REACH, most)),
            tubes if tubes <= most => (stride as u32, tubes),
            // Otherwise rows begin as far from each other as they can: at multiples of the golden ratio.
            _ => ((most as f64 * 0.618_034) as u32 | 1, most),
        };
        self.stride = stride;
        self.mask = (tubes.next_power_of_two() - 1) as u32;
    }

    /// How many numbers tubes have.
    pub(super) fn tube_count(&self) -> u32 {
        self.mask + 1
    }

    /// The number of the tube at these strips.
    #[inline(always)]
    pub(super) fn tube(&self, [row, column]: [u32; 2]) -> u32 {
        row.wrapping_mul(self.stride).wrapping_add(column) & self.mask
    }

    /// Writes the entries of a box that is not [oversized](Self::is_oversized), home first, and returns their number; those past it are
    /// unspecified.
    #[inline(always)]
    pub(super) fn write_entries<const D: usize>(
        &self,
        index: u32,
        span: &TubeSpan,
        list: &mut [Placed; MAX_ENTRIES],
    ) -> usize {
        let ([rows, columns], home) = (span.beyond(), self.tube(span.first));
        // The cut axes on which each is a ghost, as bits. The second of two is a ghost on the axis along which the box reaches two strips.
        let (axes, most) = match D > 2 {
            true => ([0, 2 - rows, 2, 3], 4),
            false => ([0, 1, 2, 3], 2),
        };
        for (entry, axes) in list.iter_mut().zip(axes).take(most) {
            let tube = home.wrapping_add((axes & 1) * self.stride + (axes >> 1)) & self.mask;
            let owner = Owner::new(index, axes);
            *entry = Placed { tube, owner };
        }
        ((1 + rows) * (1 + columns)) as usize
    }

    /// Whether a box that reaches these tubes belongs to a further class: it is more than two strips wide on some axis, too long along
    /// the first, or so far away that strips do not tell it apart from others.
    #[inline(always)]
    pub(super) fn is_oversized<const D: usize>(&self, aabb: &Aabb<R, D>, span: &TubeSpan) -> bool {
        let [rows, columns] = span.beyond();
        let length = aabb.maxs[0] - aabb.mins[0];
        let is_long = self.longest.is_some_and(|longest| length > longest);
        let mut is_far = false;
        for cut in 0..(D - 1).min(2) {
            // The first strip and the last do not tell boxes apart, unless there is only one. The first less one wraps around.
            let is_cut = self.axes[cut].per_length != R::ZERO;
            is_far |= is_cut & (span.first[cut].wrapping_sub(1) > LAST_STRIP - 2);
        }
        ((rows | columns) > 1) | is_long | is_far
    }

    /// The tubes that a box reaches; unspecified for an invalid one.
    #[inline(always)]
    pub(super) fn tube_span<const D: usize>(&self, aabb: &Aabb<R, D>) -> TubeSpan {
        // The distance from the origin in strips. Non-decreasing if `origin` is finite and `per_length` not negative: subtraction and
        // multiplication round monotonically, and [`Lanes::truncated`] is monotone. The NaN of 0 · ∞ becomes strip 0, which agrees:
        // then negative offsets are in strip 0 too, and positive ones in the last. An axis that is not cut has one strip.
        let at = |corner: &[R; D], cut: usize| {
            let Strips { origin, per_length } = self.axes[cut];
            (corner[(cut + 1).min(D - 1)] - origin) * per_length
        };
        let Aabb { mins, maxs } = aabb;
        let offsets = [at(mins, 0), at(mins, 1), at(maxs, 0), at(maxs, 1)];
        let [row, column, last_row, last_column] = R::Lanes::truncated(offsets);
        // In two dimensions the compiler then knows that there is one column.
        let [column, last_column] = if D > 2 { [column, last_column] } else { [0; 2] };
        TubeSpan {
            first: [row, column],
            last: [last_row, last_column],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tubes_that_overlapping_boxes_reach_have_different_numbers() {
        let strips = [1, 2, 3, 4, 5, 31, 63, 64, 1023, 1024, 1025, 1 << 20];
        for count in [25, 63, 64, 65, 1000, 4096, 5000, 1 << 20] {
            for rows in strips {
                check(1, [rows, 1], count);
                for columns in strips {
                    check(2, [rows, columns], count);
                }
            }
        }
    }

    fn check(cuts: usize, strips: [u64; 2], count: usize) {
        let mut grid = Grid::<f32>::default();
        grid.number_tubes(cuts, strips, count);
        assert!(u64::from(grid.tube_count()) <= 2 * count.max(64) as u64);
        let rows = REACH as u32;
        let columns = rows * (cuts as u32 - 1);
        for row in 1000 - rows..=1000 + rows {
            for column in 2000 - columns..=2000 + columns {
                let is_same = grid.tube([row, column]) == grid.tube([1000, 2000]);
                assert_eq!(is_same, [row, column] == [1000, 2000], "{grid:?}");
            }
        }
        let [first, last] = [[7, 8], [8, 9]];
        let mut entries = [Placed::default(); MAX_ENTRIES];
        assert_eq!(
            grid.write_entries::<3>(0, &TubeSpan { first, last }, &mut entries),
            4
        );
        let tubes = [first, [8, 8], [7, 9], last].map(|strips| grid.tube(strips));
        assert_eq!(entries.map(|entry| entry.tube), tubes);
    }
}
