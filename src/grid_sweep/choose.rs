//! How a grid is chosen: from a sample of the boxes, whose sizes and places it suits.

use super::grid::{Grid, Strips, cut_axes};
use super::members::Members;
use crate::aabb::Aabb;
use crate::parallel;
use crate::real::Real;
use crate::tuning::kernel::{
    BOXES_PER_STRIP, CANDIDATES_A_BOX, GRID_MARGIN, GRID_PLACE_QUANTILES, GRID_SAMPLE,
    GRID_SIZE_QUANTILE, LONG_FROM, LONG_QUANTILE, NARROWED_UP_TO, ONE_CUT_CANDIDATES,
    ONE_CUT_SAMPLE, POINTS_A_TUBE, Sample,
};

impl<R: Real> Grid<R> {
    /// A grid that suits the members, its strips widened by `widening`.
    pub(super) fn choose<const D: usize>(
        boxes: &[Aabb<R, D>],
        members: impl Members,
        widening: f64,
    ) -> Self {
        let cuts = cut_axes::<D>();
        let n = members.count() as f64;
        let indices = sample_indices(members.count(), GRID_SAMPLE);
        let sample: Vec<_> = indices.map(|i| &boxes[members.index(i) as usize]).collect();
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
        let mut longest = axes[0].longest;
        for cut in 0..cuts {
            let AxisSample {
                size, low, spread, ..
            } = axes[cut + 1];
            // Points have no size: aim at some points per tube.
            let least = spread / root(n / POINTS_A_TUBE, cuts).max(1.0);
            let width = match size > 0.0 {
                true => size * width_in_boxes,
                false => least * widening,
            };
            // Strip numbers are 32-bit; leave room for what lies outside of the sample.
            let width = width.max(spread / f64::from(1 << 28));
            let width = if width > 0.0 { width } else { 1.0 };
            longest = longest.max(width);
            let margin = spread * GRID_MARGIN;
            grid.axes[cut] = Strips::new(low - margin, width, spread + 2.0 * margin);
        }
        if cuts > 0 {
            grid.longest = Some(R::from_f64(LONG_FROM * longest));
        }
        if cuts == 2 && !grid.fits_table(members.count()) {
            return grid.along_one_axis(boxes, members).unwrap_or(grid);
        }
        grid
    }

    /// Cuts one of the two axes only, if that makes tubes few enough for a table, and leaves few enough boxes in each that overlap
    /// along the first axis.
    ///
    /// So it does where boxes lie along a curve: a rope, or the diagonal of a cube. There a run takes a half to two thirds of the
    /// instructions that it takes without a table.
    fn along_one_axis<const D: usize>(
        &self,
        boxes: &[Aabb<R, D>],
        members: impl Members,
    ) -> Option<Self> {
        let n = members.count();
        let indices = sample_indices(n, ONE_CUT_SAMPLE);
        let sample: Vec<_> = indices.map(|i| &boxes[members.index(i) as usize]).collect();
        // Of `n` boxes, each has `n / k²` times as many candidates as `k` of them have in all.
        let k = sample.len() as f64;
        let most = (ONE_CUT_CANDIDATES * (k * k / n as f64)) as usize;
        let grids = [0, 1].map(|cut| {
            let mut grid = Self::default();
            grid.axes[cut] = self.axes[cut];
            grid.longest = self.longest;
            grid
        });
        let suits = |grid: &Self| grid.fits_table(n) && grid.candidates(&sample, most) <= most;
        grids.into_iter().find(suits)
    }

    /// How many pairs of a sample share a tube and overlap along the first axis, or any number above `most`.
    fn candidates<const D: usize>(&self, sample: &[&Aabb<R, D>], most: usize) -> usize {
        let home = |aabb: &Aabb<R, D>| self.tube_span(aabb).first;
        let mut entries: Vec<_> = sample.iter().map(|&aabb| (home(aabb), aabb)).collect();
        entries.sort_unstable_by(|(tube, a), (other, b)| {
            let [a, b] = [a, b].map(|aabb| aabb.mins[0].to_f64());
            tube.cmp(other).then(a.total_cmp(&b))
        });
        let mut count = 0;
        for (i, (tube, aabb)) in entries.iter().enumerate() {
            let following = entries[i + 1..].iter();
            let is_reached =
                |(other, b): &&([u32; 2], &Aabb<R, D>)| other == tube && b.mins[0] <= aabb.maxs[0];
            count += following.take_while(is_reached).count();
            if count > most {
                break;
            }
        }
        count
    }
}

/// Which of `n` boxes are looked at. The same ones each time, but irregularly spaced, so that a pattern in the order of the boxes
/// does not mislead.
pub(super) fn sample_indices(n: usize, sample: Sample) -> impl Iterator<Item = usize> {
    let [least, most] = sample.range;
    let count = (n / sample.one_in).clamp(least, most).min(n);
    // Fibonacci hashing within each of `count` equal parts.
    (0..count).map(move |i| {
        let [first, next] = [i, i + 1].map(|i| parallel::start_of_part(i, count, n));
        let hash = (i as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 32;
        first + hash as usize % (next - first)
    })
}

/// The square root of `x` if two axes are cut, else `x`. Unlike powers, square roots are the same on every platform, and
/// so is the order of the pairs.
fn root(x: f64, cuts: usize) -> f64 {
    if cuts > 1 { x.sqrt() } else { x }
}

/// What a sample tells about one axis. Robust: a few boxes far out or far larger change nothing.
struct AxisSample {
    /// The size that most boxes do not exceed.
    size: f64,
    /// The size that hardly any exceed.
    longest: f64,
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
            longest: quantile(&mut sizes, LONG_QUANTILE),
            low,
            spread: high - low,
        }
    }
}
