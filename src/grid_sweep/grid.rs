//! Which tube a coordinate belongs to.
//!
//! The axes after the first are cut into strips of equal width; a *tube* is a strip in two dimensions, and the crossing
//! of two strips in three. Whatever the origin and the width are, the strip number is a non-decreasing function of the
//! coordinate, and that alone makes the sweep exact: two overlapping boxes both reach the strip that holds the larger of
//! their two `mins`. So origin and width may be guessed from a sample, and the guess may be wrong.

use super::members::Members;
use crate::tuning::kernel::{
    BOXES_PER_STRIP, CANDIDATES_A_BOX, GRID_MARGIN, GRID_PLACE_QUANTILES, GRID_SAMPLE,
    GRID_SAMPLE_ONE_IN, GRID_SIZE_QUANTILE, NARROWED_UP_TO, ONE_CUT_CANDIDATES, ONE_CUT_SAMPLE,
    ONE_CUT_SAMPLE_ONE_IN, POINTS_A_TUBE, SPARE_TUBES,
};
use crate::{Aabb, Real};

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
    /// negative: subtraction and multiplication round monotonically, and so does [`Real::truncated`]. 0 · ∞ is NaN and becomes
    /// strip 0: negative offsets are in strip 0 too, positive ones in the last.
    #[inline(always)]
    fn offset(&self, coordinate: R) -> R {
        (coordinate - self.origin) * self.per_length
    }

    fn new(origin: f64, width: f64, length: f64) -> Self {
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
}

/// The tubes that a box spans: from `first` to `last` in each cut axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct TubeSpan {
    pub(super) first: [u32; 2],
    pub(super) last: [u32; 2],
}

impl TubeSpan {
    /// Whether it is more than two strips wide on some axis: such boxes are treated apart.
    #[inline(always)]
    pub(super) fn is_outsize(&self) -> bool {
        let [rows, columns] = self.beyond();
        (rows > 1) | (columns > 1)
    }

    /// How many strips a box spans besides the first. Inverted boxes, which are refused later, wrap around to large numbers.
    #[inline(always)]
    pub(super) fn beyond(&self) -> [u32; 2] {
        [0, 1].map(|cut| self.last[cut].wrapping_sub(self.first[cut]))
    }
}

impl<R: Real> Grid<R> {
    /// How many tubes there are, empty ones included.
    pub(super) fn tube_count(&self) -> u64 {
        let [rows, columns] = self.axes.map(|axis| u64::from(axis.last) + 1);
        rows.saturating_mul(columns)
    }

    /// Whether there are so few tubes that a table of them does not cost more than the boxes do.
    pub(super) fn fits_table(&self, members: usize) -> bool {
        self.tube_count() <= (members as u64 + SPARE_TUBES).min(1 << 30)
    }

    /// The same grid with one of its two cut axes only, if that makes tubes few enough for a table, and leaves few enough boxes
    /// in each that overlap along the first axis. So it does where boxes lie along a curve: a rope, or the diagonal of a cube.
    pub(super) fn cut_once<const D: usize>(
        &self,
        boxes: &[Aabb<R, D>],
        members: impl Members,
    ) -> Option<Self> {
        if cut_axes::<D>() < 2 {
            return None;
        }
        let n = members.count();
        let sample: Vec<_> = spread(n, ONE_CUT_SAMPLE_ONE_IN, ONE_CUT_SAMPLE)
            .map(|i| &boxes[members.index(i) as usize])
            .collect();
        // Of `n` boxes, each has `n / k²` times as many candidates as `k` of them have in all.
        let k = sample.len();
        let most = (ONE_CUT_CANDIDATES * (k as f64 * k as f64 / n as f64)) as usize;
        let only = |cut| {
            let mut grid = Self::default();
            grid.axes[cut] = self.axes[cut];
            grid
        };
        [0, 1]
            .into_iter()
            .find(|&cut| only(cut).fits_table(n) && self.candidates(cut, &sample, most) <= most)
            .map(only)
    }

    /// How many pairs of a sample share a strip and overlap along the first axis, or any number above `most`.
    fn candidates<const D: usize>(&self, cut: usize, sample: &[&Aabb<R, D>], most: usize) -> usize {
        let mut entries: Vec<_> = sample
            .iter()
            .map(|aabb| (self.tube_span(aabb).first[cut], aabb))
            .collect();
        entries.sort_unstable_by(|(strip, a), (other, b)| {
            let [a, b] = [a, b].map(|aabb| aabb.mins[0].to_f64());
            strip.cmp(other).then(a.total_cmp(&b))
        });
        let mut count = 0;
        for (i, (strip, aabb)) in entries.iter().enumerate() {
            let following = entries[i + 1..].iter();
            let reached =
                following.take_while(|(other, b)| other == strip && b.mins[0] <= aabb.maxs[0]);
            count += reached.count();
            if count > most {
                break;
            }
        }
        count
    }

    /// Extends the strips to the greatest number that they can have.
    pub(super) fn extend<const D: usize>(&mut self) {
        for axis in &mut self.axes[..cut_axes::<D>()] {
            axis.last = 1 << 31;
        }
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
        let strips = R::truncated([
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

    /// A grid that suits the members, its strips widened by `widening`.
    pub(super) fn choose<const D: usize>(
        boxes: &[Aabb<R, D>],
        members: impl Members,
        widening: f64,
    ) -> Self {
        let cuts = cut_axes::<D>();
        let n = members.count() as f64;
        let sample: Vec<_> = scattered(members.count())
            .map(|i| &boxes[members.index(i) as usize])
            .collect();
        let axes: [AxisSample; 3] = core::array::from_fn(|k| AxisSample::of(&sample, k.min(D - 1)));

        // Boxes per unit of volume times the volume of a row of boxes: candidates per box, if strips were one box wide.
        // Only an upper bound is wanted, so a flat axis counts as one box thick.
        let share = |AxisSample { size, spread, .. }: &AxisSample| {
            if size < spread { size / spread } else { 1.0 }
        };
        let density = axes[..D.min(3)].iter().fold(n, |n, axis| n * share(axis));
        let widest = BOXES_PER_STRIP[cuts.saturating_sub(1)];
        let affordable = root(CANDIDATES_A_BOX / density, cuts);
        let width_in_boxes = affordable.clamp(widest / NARROWED_UP_TO, widest) * widening;

        let mut grid = Self::default();
        for cut in 0..cuts {
            let AxisSample { size, low, spread } = axes[cut + 1];
            // Points have no size: aim at some points per tube.
            let least = spread / root(n / POINTS_A_TUBE, cuts).max(1.0);
            let width = if size > 0.0 {
                size * width_in_boxes
            } else {
                least * widening
            };
            // Strip numbers are 32-bit; leave room for what lies outside of the sample.
            let width = width.max(spread / f64::from(1 << 28));
            let width = if width > 0.0 { width } else { 1.0 };
            grid.axes[cut] = Strips::new(
                low - spread * GRID_MARGIN,
                width,
                spread * (1.0 + 2.0 * GRID_MARGIN),
            );
        }
        grid
    }
}

/// The square root of `x` if two axes are cut, else `x`. Unlike powers, square roots are the same on every platform, and
/// so is the order of the pairs.
fn root(x: f64, cuts: usize) -> f64 {
    if cuts > 1 { x.sqrt() } else { x }
}

/// Which of `n` boxes are looked at to choose a grid.
pub(super) fn scattered(n: usize) -> impl Iterator<Item = usize> {
    spread(n, GRID_SAMPLE_ONE_IN, GRID_SAMPLE)
}

/// One in so many of the numbers below `n`, at least and at most so many, or all of them if they are few: the same ones each
/// time, but irregularly spaced, so that a pattern in the order of the boxes does not mislead.
fn spread(n: usize, one_in: usize, [least, most]: [usize; 2]) -> impl Iterator<Item = usize> {
    let count = (n / one_in).clamp(least, most).min(n);
    // Fibonacci hashing within each of `count` equal parts.
    (0..count).map(move |i| {
        let [first, next] = [i, i + 1].map(|i| i * n / count);
        let hash = (i as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 32;
        first + hash as usize % (next - first)
    })
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

/// What a sample tells about one axis. Robust: a few boxes far out or far larger change nothing.
struct AxisSample {
    /// The size that most boxes do not exceed.
    size: f64,
    /// The least coordinate of `mins`, except for a few.
    low: f64,
    /// The distance from there to the greatest, except for a few.
    spread: f64,
}

impl AxisSample {
    fn of<R: Real, const D: usize>(sample: &[&Aabb<R, D>], axis: usize) -> Self {
        let quantile = |numbers: &mut [f64], q: f64| {
            if numbers.is_empty() {
                return 0.0;
            }
            let index = ((numbers.len() - 1) as f64 * q) as usize;
            *numbers.select_nth_unstable_by(index, f64::total_cmp).1
        };
        let extents = sample
            .iter()
            .map(|b| [b.mins[axis].to_f64(), b.maxs[axis].to_f64()]);
        let mut sizes: Vec<f64> = extents.clone().map(|[min, max]| max - min).collect();
        let mut mins: Vec<f64> = extents
            .map(|[min, _]| min)
            .filter(|x| x.is_finite())
            .collect();
        let [low, high] = GRID_PLACE_QUANTILES.map(|q| quantile(&mut mins, q));
        Self {
            size: quantile(&mut sizes, GRID_SIZE_QUANTILE),
            low,
            spread: high - low,
        }
    }
}
