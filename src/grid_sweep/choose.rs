//! How a grid is chosen: by a sample of the boxes, for their sizes and places.

use super::grid::{Grid, Strips};
use crate::aabb::Aabb;
use crate::parallel::start_of_part;
use crate::real::Real;
use crate::tuning::kernel::{
    Aim, BOXES_A_TUBE, BOXES_PER_STRIP, CANDIDATES_A_BOX, COMPARED_A_PAIR, FITTING,
    GRID_PLACE_QUANTILES, GRID_SPARE, LONG_FROM, NARROWED_UP_TO, Sample,
};

impl<R: Real> Grid<R> {
    /// A grid for boxes up to some size. The [shares](Aim::sizes) of the aim are those of the members that do not exceed that size on the cut
    /// axes, and along the first axis of those that are not too large for the strips.
    pub(super) fn choose<const D: usize>(boxes: &[Aabb<R, D>], members: &[u32], aim: Aim) -> Self {
        let cuts = (D - 1).min(2);
        let [cut_quantile, first_quantile] = aim.sizes;
        let n = members.len() as f64;
        let sample = sample_of(members, aim.sample).map(|&i| &boxes[i as usize]);
        let mut sample: Vec<_> = sample.collect();
        let mut cut_samples = [1, 2].map(|k| {
            let axis = AxisSample::of(&sample, k.min(D - 1), cut_quantile);
            // Boxes that are too large along this axis go into another class: the other axes do without them.
            if k <= cuts {
                let largest = axis.size * BOXES_PER_STRIP[cuts - 1];
                sample.retain(|aabb| aabb.maxs[k].to_f64() - aabb.mins[k].to_f64() <= largest);
            }
            axis
        });
        if aim.is_narrow {
            // Boxes that are too large along either axis may lie far away, and make the others look sparse. Only now is it known which they are.
            for (k, axis) in (1..=cuts).zip(&mut cut_samples) {
                let size = axis.size;
                *axis = AxisSample::of(&sample, k, cut_quantile);
                axis.size = size;
            }
        }
        let first = AxisSample::of(&sample, 0, first_quantile);
        let cut_samples = &cut_samples[..cuts];

        // Boxes per unit of volume, times the volume of a row of boxes: the candidates per box if strips were one box wide. An upper
        // bound is enough, so a flat axis counts as one box thick.
        let first_share = share_of(first.size, first.spread).max(first.mean_share);
        let density = cut_samples.iter().map(|cut| share_of(cut.size, cut.spread));
        let density = density.fold(n * first_share, |density, share| density * share);
        let affordable = root(CANDIDATES_A_BOX / density, cuts);
        let widest = BOXES_PER_STRIP[cuts.saturating_sub(1)];
        let narrowest = match aim.is_narrow {
            false => widest / NARROWED_UP_TO,
            true => 1.0,
        };
        // Where boxes lie far apart, tubes of a few boxes each would cost more than they save.
        let places = cut_samples.iter().map(|axis| axis.inner_spread / axis.size);
        let sparse = Some(root(places.product::<f64>() / (n / BOXES_A_TUBE), cuts));
        let sparse = sparse.filter(|width| width.is_finite());
        let widest = widest.max(sparse.unwrap_or(widest));
        let width_in_boxes = affordable.clamp(narrowest, widest);

        let mut grid = Self::default();
        let mut longest = first.size;
        let mut strips = [1; 2];
        let spread_axes = cut_samples.iter().filter(|axis| axis.spread > 0.0).count();
        let points = root(n / BOXES_A_TUBE, spread_axes).max(1.0);
        for (cut, axis) in cut_samples.iter().enumerate() {
            // Points have no size: aim at some points a tube, also where most have the same coordinate. Where all have, any width will do.
            let [inner, outer] = [axis.inner_spread, axis.spread].map(|spread| spread / points);
            let widths = [axis.size * width_in_boxes, inner, outer];
            let width = widths.into_iter().find(|&w| w > 0.0).unwrap_or(1.0);
            if width.is_finite() {
                longest = longest.max(width);
            }
            strips[cut] = (GRID_SPARE * axis.spread / width) as u64;
            grid.axes[cut] = Strips::new(axis.middle, width);
        }
        grid.longest = (D > 1).then(|| R::from_f64(LONG_FROM * longest));
        grid.number_tubes(cuts, strips, members.len());
        grid
    }
}

/// How many times more comparisons than it may a sweep takes, by a sample, of so many members that a grid has taken. `comparisons` is
/// the number of their ordered pairs in all tubes. The sweep compares those that overlap along the first axis. It may take
/// [some](FITTING) for each box, and some for each pair.
pub(super) fn excess<R: Real, const D: usize>(
    boxes: &[Aabb<R, D>],
    members: &[u32],
    grid: &Grid<R>,
    taken: usize,
    comparisons: u64,
) -> f64 {
    let (taken, comparisons) = (taken as f64, comparisons as f64);
    if comparisons <= FITTING * taken {
        return 0.0;
    }
    // A pair of the sample stands for a few comparisons of each box.
    let size = (members.len() as f64).sqrt() as usize / 2;
    let range = [size.max(16); 2];
    let sample = sample_of(members, Sample { one_in: 1, range }).map(|&i| &boxes[i as usize]);
    // Collected first, so that memory is allocated once.
    let mut sample: Vec<_> = sample.collect();
    sample.retain(|aabb| !grid.is_oversized(aabb, &grid.tube_span(aabb)));
    let [overlaps, pairs] = overlaps_and_pairs(sample);
    overlaps * comparisons / (taken * (FITTING + COMPARED_A_PAIR as f64 * pairs * taken))
}

/// Of the ordered pairs of a sample of boxes, the shares that overlap along the first axis, and that are pairs.
pub(super) fn overlaps_and_pairs<R: Real, const D: usize>(
    mut sample: Vec<&Aabb<R, D>>,
) -> [f64; 2] {
    sample.sort_unstable_by(|a, b| a.mins[0].to_f64().total_cmp(&b.mins[0].to_f64()));
    // At least one, for a sample cannot tell less.
    let (mut overlaps, mut pairs) = (1, 0);
    for (i, aabb) in sample.iter().enumerate() {
        let following = sample[i + 1..].iter();
        for other in following.take_while(|other| other.mins[0] <= aabb.maxs[0]) {
            overlaps += 1;
            pairs += usize::from(aabb.intersects(other));
        }
    }
    [overlaps, pairs].map(|n| n as f64 / (sample.len().max(1) as f64).powi(2))
}

/// A sample of these items: the same each time, but at irregular distances, so that a pattern in their order does not mislead.
pub(super) fn sample_of<T>(items: &[T], sample: Sample) -> impl Iterator<Item = &T> {
    let ([least, most], n) = (sample.range, items.len());
    let count = (n / sample.one_in).clamp(least, most).min(n);
    // Fibonacci hashing within each of `count` equal parts.
    (0..count).map(move |i| {
        let [first, next] = [i, i + 1].map(|i| start_of_part(i, count, n));
        let hash = (i as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 32;
        &items[first + hash as usize % (next - first)]
    })
}

/// The square root of `x` if two axes are cut, else `x`. Unlike powers, square roots are the same on every platform, and so is the grid.
fn root(x: f64, cuts: usize) -> f64 {
    if cuts > 1 { x.sqrt() } else { x }
}

/// A size as a share of the spread, at most 1.
fn share_of(size: f64, spread: f64) -> f64 {
    if size < spread { size / spread } else { 1.0 }
}

/// One axis of a sample. A few boxes that are far out or far larger change nothing.
struct AxisSample {
    /// The size that a share of the boxes does not exceed. Without a sign, because that of ∞ - ∞ depends on the platform.
    size: f64,
    /// The mean size, as a share of the spread.
    mean_share: f64,
    /// The median of `mins`.
    middle: f64,
    /// The distance between the least and the greatest of `mins`, except for a few.
    spread: f64,
    /// Twice the distance between their quartiles.
    inner_spread: f64,
}

impl AxisSample {
    fn of<R: Real, const D: usize>(sample: &[&Aabb<R, D>], axis: usize, share: f64) -> Self {
        let size = |b: &&Aabb<R, D>| (b.maxs[axis].to_f64() - b.mins[axis].to_f64()).abs();
        let mut sizes: Vec<f64> = sample.iter().map(size).collect();
        let mins = sample.iter().map(|b| b.mins[axis].to_f64());
        let mut mins: Vec<f64> = mins.filter(|min| min.is_finite()).collect();
        let [low, high] = GRID_PLACE_QUANTILES.map(|q| quantile(&mut mins, q));
        let [lower, upper] = [0.25, 0.75].map(|q| quantile(&mut mins, q));
        let spread = high - low;
        let shares = sizes.iter().map(|&size| share_of(size, spread));
        Self {
            mean_share: shares.sum::<f64>() / sizes.len().max(1) as f64,
            size: quantile(&mut sizes, share),
            middle: quantile(&mut mins, 0.5),
            spread,
            inner_spread: 2.0 * (upper - lower),
        }
    }
}

/// The number that a share of the numbers does not exceed; 0 if there are none.
fn quantile(numbers: &mut [f64], share: f64) -> f64 {
    if numbers.is_empty() {
        return 0.0;
    }
    let index = ((numbers.len() - 1) as f64 * share) as usize;
    *numbers.select_nth_unstable_by(index, f64::total_cmp).1
}
