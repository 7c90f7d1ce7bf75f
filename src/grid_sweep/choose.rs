//! How a grid is chosen: from a sample of the boxes, whose sizes and places it suits.

use super::grid::{Grid, Strips, cut_axes};
use super::members::Members;
use crate::aabb::Aabb;
use crate::parallel;
use crate::real::Real;
use crate::tuning::kernel::{
    BOXES_A_TUBE, BOXES_PER_STRIP, CANDIDATES_A_BOX, GRID_PLACE_QUANTILES, GRID_SAMPLE,
    GRID_SIZE_QUANTILE, GRID_SPARE, LONG_FROM, NARROWED_UP_TO, ONE_TUBE_UP_TO, POINTS_A_TUBE,
    Sample,
};

impl<R: Real> Grid<R> {
    /// A single tube.
    pub(super) fn of_one_tube<const D: usize>(boxes: &[Aabb<R, D>], members: impl Members) -> Self {
        if members.count() <= ONE_TUBE_UP_TO {
            return Self::default();
        }
        let sample = sample(boxes, members);
        let axis = AxisSample::of(&sample, 0, GRID_SIZE_QUANTILE);
        let mut grid = Self::default();
        grid.longest = Some(R::from_f64(LONG_FROM * axis.size));
        grid
    }

    /// A grid that suits the members: boxes of a size that this share of them does not exceed. For a crowd, strips are as narrow as
    /// boxes if that helps.
    pub(super) fn choose<const D: usize>(
        boxes: &[Aabb<R, D>],
        members: impl Members,
        size_quantile: f64,
        is_crowd: bool,
    ) -> Self {
        let cuts = cut_axes::<D>();
        let n = members.count() as f64;
        let mut sample = sample(boxes, members);
        let cut_samples = [1, 2].map(|k| {
            let axis = AxisSample::of(&sample, k.min(D - 1), size_quantile);
            // For the axes to come: those that are too large along this one will be in another class.
            if k <= cuts {
                let largest = axis.size * BOXES_PER_STRIP[cuts - 1];
                sample.retain(|aabb| aabb.maxs[k].to_f64() - aabb.mins[k].to_f64() <= largest);
            }
            axis
        });
        let first = AxisSample::of(&sample, 0, size_quantile);

        // Boxes per unit of volume times the volume of a row of boxes: candidates per box, if strips were one box wide.
        // Only an upper bound is wanted, so a flat axis counts as one box thick.
        let share = |size: f64, spread: f64| if size < spread { size / spread } else { 1.0 };
        let first_share = share(first.size, first.spread).max(first.mean_share);
        let density = cut_samples[..cuts]
            .iter()
            .fold(n * first_share, |n, axis| n * share(axis.size, axis.spread));
        let widest = BOXES_PER_STRIP[cuts.saturating_sub(1)];
        let affordable = root(CANDIDATES_A_BOX / density, cuts);
        let narrowest = match is_crowd {
            false => widest / NARROWED_UP_TO,
            true => 1.0,
        };
        // Where boxes lie far apart, tubes of a few boxes each would cost more than they save.
        let places = cut_samples[..cuts]
            .iter()
            .fold(1.0, |places, axis| places * (axis.inner_spread / axis.size));
        let sparse = root(places / (n / BOXES_A_TUBE), cuts);
        let widest = if sparse.is_finite() {
            sparse.max(widest)
        } else {
            widest
        };
        let width_in_boxes = affordable.clamp(narrowest, widest);

        let mut grid = Self::default();
        let mut longest = first.size;
        let mut strips = [1; 2];
        for cut in 0..cuts {
            let axis = &cut_samples[cut];
            // Points have no size: aim at some points per tube.
            let width = match axis.size > 0.0 {
                true => axis.size * width_in_boxes,
                false => axis.dense_spread() / root(n / POINTS_A_TUBE, cuts).max(1.0),
            };
            let width = if width > 0.0 { width } else { 1.0 };
            longest = longest.max(width);
            strips[cut] = (GRID_SPARE * axis.spread / width) as u64;
            grid.axes[cut] = Strips::new(axis.middle, width);
        }
        if cuts > 0 {
            grid.longest = Some(R::from_f64(LONG_FROM * longest));
        }
        grid.number_tubes::<D>(strips, members.count());
        grid
    }
}

/// The boxes that are looked at.
fn sample<R, const D: usize>(boxes: &[Aabb<R, D>], members: impl Members) -> Vec<&Aabb<R, D>> {
    sample_indices(members.count(), GRID_SAMPLE)
        .map(|i| &boxes[members.index(i) as usize])
        .collect()
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
    /// The size that a share of the boxes does not exceed.
    size: f64,
    /// The mean size, as a part of the spread.
    mean_share: f64,
    /// The middle one of all `mins`.
    middle: f64,
    /// The distance between the least and the greatest of `mins`, except for a few.
    spread: f64,
    /// Twice the distance that holds the inner half of them.
    inner_spread: f64,
    /// The finite `mins`, in no order.
    mins: Vec<f64>,
}

impl AxisSample {
    fn of<R: Real, const D: usize>(sample: &[&Aabb<R, D>], axis: usize, share: f64) -> Self {
        let extents = sample
            .iter()
            .map(|b| [b.mins[axis].to_f64(), b.maxs[axis].to_f64()]);
        let mut sizes: Vec<f64> = extents.clone().map(|[min, max]| max - min).collect();
        let mut mins: Vec<f64> = extents.map(|[min, _]| min).collect();
        mins.retain(|min| min.is_finite());
        let [low, high] = GRID_PLACE_QUANTILES.map(|q| quantile(&mut mins, q));
        let spread = high - low;
        let [lower, upper] = [0.25, 0.75].map(|q| quantile(&mut mins, q));
        let shares = sizes
            .iter()
            .map(|&size| if size < spread { size / spread } else { 1.0 });
        Self {
            mean_share: shares.sum::<f64>() / sizes.len().max(1) as f64,
            size: quantile(&mut sizes, share),
            middle: quantile(&mut mins, 0.5),
            spread,
            inner_spread: 2.0 * (upper - lower),
            mins,
        }
    }

    /// How far the boxes would be spread if all lay as densely as most.
    fn dense_spread(&self) -> f64 {
        let mut mins = self.mins.clone();
        mins.sort_unstable_by(f64::total_cmp);
        let mut gaps: Vec<_> = mins.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let spread = quantile(&mut gaps, 0.5) * mins.len() as f64;
        if spread > 0.0 { spread } else { self.spread }
    }
}

/// The number that a share of numbers does not exceed; 0 if there are none.
fn quantile(numbers: &mut [f64], share: f64) -> f64 {
    if numbers.is_empty() {
        return 0.0;
    }
    let index = ((numbers.len() - 1) as f64 * share) as usize;
    *numbers.select_nth_unstable_by(index, f64::total_cmp).1
}
