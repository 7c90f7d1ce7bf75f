//! Which tube a coordinate belongs to.
//!
//! The axes after the first are cut into strips of equal width; a *tube* is a strip in two dimensions, and the crossing
//! of two strips in three. Whatever the origin and the width are, the strip number is a non-decreasing function of the
//! coordinate, and that alone makes the sweep exact: two overlapping boxes both reach the strip that holds the larger of
//! their two `mins`. So origin and width may be guessed from a sample, and the guess may be wrong.

use crate::aabb::Aabb;
use crate::lanes::Lanes;
use crate::real::Real;
use crate::tuning::kernel::SPARE_TUBES;

/// One axis, cut into strips.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Strips<R> {
    origin: R,
    per_length: R,
    /// The number of the last strip, which takes all farther coordinates.
    pub(super) last: u32,
}

impl<R: Real> Strips<R> {
    /// How many strips a coordinate lies beyond the origin. Non-decreasing as long as `origin` is finite and `per_length` not
    /// negative: subtraction and multiplication round monotonically, and so does [`Lanes::truncated`]. 0 · ∞ is NaN and becomes
    /// strip 0: negative offsets are in strip 0 too, positive ones in the last.
    #[inline(always)]
    fn offset(&self, coordinate: R) -> R {
        (coordinate - self.origin) * self.per_length
    }

    pub(super) fn new(origin: f64, width: f64, length: f64) -> Self {
        let origin = R::from_f64(origin);
        Self {
            origin: if origin.is_finite() { origin } else { R::ZERO },
            per_length: R::from_f64(1.0 / width),
            last: (length / width) as u32,
        }
    }
}

/// The strips of the axes that are cut: the second, and in three dimensions the third.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Grid<R> {
    pub(super) axes: [Strips<R>; 2],
    /// How long a box may be along the first axis, if that matters. One that is longer would make windows long for all that are looked up
    /// in its tube.
    pub(super) longest: Option<R>,
}

/// The tubes that a box spans: from `first` to `last` in each cut axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct TubeSpan {
    pub(super) first: [u32; 2],
    pub(super) last: [u32; 2],
}

impl TubeSpan {
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

impl<R: Real> Grid<R> {
    /// How many tubes are in a row: the strips of the second cut axis.
    pub(super) fn columns(&self) -> u32 {
        self.axes[1].last + 1
    }

    /// How many tubes there are, empty ones included.
    pub(super) fn tube_count(&self) -> u64 {
        let [rows, columns] = self.axes.map(|axis| u64::from(axis.last) + 1);
        rows.saturating_mul(columns)
    }

    /// Whether there are so few tubes that a table of them does not cost more than the boxes do.
    pub(super) fn fits_table(&self, members: usize) -> bool {
        self.tube_count() <= (members as u64 + SPARE_TUBES).min(1 << 30)
    }

    /// Extends the strips to the greatest number that they can have.
    pub(super) fn extend<const D: usize>(&mut self) {
        for axis in &mut self.axes[..cut_axes::<D>()] {
            axis.last = 1 << 31;
        }
    }

    /// Whether a box that spans these tubes is more than two strips wide on some axis, or too long: such boxes are treated apart.
    #[inline(always)]
    pub(super) fn is_oversized<const D: usize>(&self, aabb: &Aabb<R, D>, span: &TubeSpan) -> bool {
        let [rows, columns] = span.beyond();
        let length = aabb.maxs[0] - aabb.mins[0];
        let is_long = self.longest.is_some_and(|longest| length > longest);
        (rows > 1) | (columns > 1) | is_long
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
        for cut in 0..cuts {
            span.first[cut] = strips[cut].min(self.axes[cut].last);
            span.last[cut] = strips[2 + cut].min(self.axes[cut].last);
        }
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
