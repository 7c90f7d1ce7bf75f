//! A race of all methods on the same frames, in turns: the paper's, its baseline, and ours.

use anyhow::{Context, Result, ensure};
use serde_json::Value;
use std::time::{Duration, Instant};
use unisize::{Aabb, GridSweep, PairFinder, RankSweep};
use unisize_reference::SweepAndPrune;
use unisize_scenes::DriftingBoxes;

/// A contestant of a race.
pub(crate) struct Method<const D: usize> {
    pub(crate) name: &'static str,
    /// The name of its times in a row.
    column: &'static str,
    pub(crate) finder: Box<dyn PairFinder<f32, D>>,
}

fn method<const D: usize>(
    name: &'static str,
    column: &'static str,
    finder: impl PairFinder<f32, D> + 'static,
) -> Method<D> {
    let finder = Box::new(finder);
    Method {
        name,
        column,
        finder,
    }
}

/// The methods of the paper and ours.
pub(crate) fn methods<const D: usize>() -> Vec<Method<D>> {
    vec![
        method("SweepAndPrune", "sweep_and_prune", SweepAndPrune::default()),
        method("RankSweep", "rank_sweep", RankSweep::default()),
        method("GridSweep", "grid_sweep", GridSweep::default()),
    ]
}

/// Milliseconds, frame by frame.
#[derive(Clone, Debug, Default)]
pub(crate) struct Times(pub(crate) Vec<f64>);

impl Times {
    pub(crate) fn push(&mut self, time: Duration) {
        self.0.push(time.as_secs_f64() * 1e3);
    }

    pub(crate) fn mean(&self) -> f64 {
        self.0.iter().sum::<f64>() / self.0.len() as f64
    }

    pub(crate) fn worst(&self) -> f64 {
        self.0.iter().copied().fold(0.0, f64::max)
    }

    pub(crate) fn median(&self) -> f64 {
        let mut sorted = self.0.clone();
        sorted.sort_unstable_by(f64::total_cmp);
        sorted.get(sorted.len() / 2).copied().unwrap_or(f64::NAN)
    }
}

/// The outcome of a race, with times in the order of the methods.
pub(crate) struct Outcome {
    pub(crate) times: Vec<Times>,
    /// The number of pairs of every frame.
    pub(crate) pairs: Vec<usize>,
}

impl Outcome {
    /// The median milliseconds of each method, as columns of a row.
    pub(crate) fn medians<const D: usize>(
        &self,
        methods: &[Method<D>],
    ) -> impl Iterator<Item = (&'static str, Value)> {
        let times = methods.iter().zip(&self.times);
        times.map(|(method, times)| (method.column, times.median().into()))
    }
}

/// Lets every method find the pairs of every frame. The first frame, which allocates memory, is not timed.
///
/// `next` replaces the boxes by those of the next frame. All methods must agree.
pub(crate) fn race<const D: usize>(
    methods: &mut [Method<D>],
    frames: usize,
    mut next: impl FnMut(&mut Vec<Aabb<f32, D>>),
) -> Result<Outcome> {
    let (mut boxes, mut found) = (Vec::new(), Vec::new());
    let mut times = vec![Times::default(); methods.len()];
    let mut pairs = Vec::new();
    for frame in 0..=frames {
        next(&mut boxes);
        let mut expected = None;
        for (method, times) in methods.iter_mut().zip(&mut times) {
            let start = Instant::now();
            let result = method.finder.find_pairs(&boxes, &mut found);
            let time = start.elapsed();
            result.context(method.name)?;
            let hash = fingerprint(&found);
            let is_equal = *expected.get_or_insert(hash) == hash;
            ensure!(is_equal, "frame {frame}: {} differs", method.name);
            if frame > 0 {
                times.push(time);
            }
        }
        if frame > 0 {
            pairs.push(found.len());
        }
    }
    Ok(Outcome { times, pairs })
}

/// A hash of a set of pairs, whatever their order.
fn fingerprint(pairs: &[[u32; 2]]) -> u64 {
    let mix = |&[a, b]: &[u32; 2]| {
        // The finalizer of SplitMix64.
        let mut x = u64::from(a) << 32 | u64::from(b);
        x = (x ^ x >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        x = (x ^ x >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        x ^ x >> 31
    };
    let count = pairs.len() as u64;
    pairs.iter().map(mix).fold(count, u64::wrapping_add)
}

/// Replaces boxes by those of side 1 at these lower corners.
pub(crate) fn unit_boxes<const D: usize>(mins: &[[f32; D]], boxes: &mut Vec<Aabb<f32, D>>) {
    boxes.clear();
    let unit = |mins: &[f32; D]| Aabb::new(*mins, mins.map(|x| x + 1.0));
    boxes.extend(mins.iter().map(unit));
}

/// Replaces boxes by those of side 1 that have drifted on.
pub(crate) fn drift<const D: usize>(
    drifting: &mut DriftingBoxes<D>,
    boxes: &mut Vec<Aabb<f32, D>>,
) {
    drifting.advance();
    unit_boxes(drifting.mins(), boxes);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_methods_find_the_same() {
        let mut drifting = DriftingBoxes::<3>::new(500, 0.5, 7);
        let outcome = race(&mut methods(), 3, |boxes| drift(&mut drifting, boxes)).unwrap();
        assert!(outcome.times.iter().all(|times| times.0.len() == 3));
        assert!(outcome.pairs.iter().all(|&pairs| pairs > 100));
    }

    #[test]
    fn fingerprints_tell_sets_apart_and_not_orders() {
        let pairs = [[1, 2], [3, 4], [1, 4]];
        assert_eq!(fingerprint(&pairs), fingerprint(&[[1, 4], [1, 2], [3, 4]]));
        assert_ne!(fingerprint(&pairs), fingerprint(&[[1, 2], [3, 4], [2, 4]]));
        assert_ne!(fingerprint(&pairs), fingerprint(&pairs[..2]));
    }
}
