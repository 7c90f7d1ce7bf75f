//! Everything that finds pairs, under one roof: the paper's method, those that it is compared with, and ours.

use anyhow::{Context, Result};
use plotters::style::RGBColor;
use std::time::{Duration, Instant};
use unisize::{
    Aabb, CoherentSweepAndPrune, DualAxisSweep, GridSweep, PairFinder, RankSweep,
    StreamedSegmentTree, SweepAndPrune,
};

/// The cutoff at which the streamed segment tree is fastest for boxes of one size.
const BEST_CUTOFF: usize = 2000;

/// What is raced.
pub(crate) trait Method<const D: usize> {
    fn name(&self) -> &'static str;

    /// The colour of its lines.
    fn color(&self) -> RGBColor;

    /// Finds the pairs of the boxes of a frame, and says how long it took.
    fn run(&mut self, boxes: &[Aabb<f32, D>]) -> Result<Duration>;

    /// How many pairs there are now.
    fn pair_count(&self) -> usize;

    /// The pairs, if they are exactly those of the boxes: not where boxes are kept with a margin.
    fn exact_pairs(&self) -> Option<&[[u32; 2]]>;
}

struct Finder<F> {
    name: &'static str,
    color: RGBColor,
    finder: F,
    pairs: Vec<[u32; 2]>,
}

impl<F: PairFinder<f32, D>, const D: usize> Method<D> for Finder<F> {
    fn name(&self) -> &'static str {
        self.name
    }

    fn color(&self) -> RGBColor {
        self.color
    }

    fn run(&mut self, boxes: &[Aabb<f32, D>]) -> Result<Duration> {
        let start = Instant::now();
        let found = self.finder.find_pairs(boxes, &mut self.pairs);
        let elapsed = start.elapsed();
        found.context(self.name)?;
        Ok(elapsed)
    }

    fn pair_count(&self) -> usize {
        self.pairs.len()
    }

    fn exact_pairs(&self) -> Option<&[[u32; 2]]> {
        Some(&self.pairs)
    }
}

/// A name, a colour and how to make it.
fn method<F: PairFinder<f32, D> + 'static, const D: usize>(
    name: &'static str,
    [r, g, b]: [u8; 3],
    finder: F,
) -> Box<dyn Method<D>> {
    Box::new(Finder {
        name,
        color: RGBColor(r, g, b),
        finder,
        pairs: Vec::new(),
    })
}

pub(crate) fn grid_sweep<const D: usize>() -> Box<dyn Method<D>> {
    method("GridSweep", [213, 0, 0], GridSweep::default())
}

pub(crate) fn rank_sweep<const D: usize>() -> Box<dyn Method<D>> {
    method("RankSweep", [225, 120, 0], RankSweep::default())
}

pub(crate) fn dual_axis_sweep<const D: usize>() -> Box<dyn Method<D>> {
    method("DualAxisSweep", [150, 120, 0], DualAxisSweep::default())
}

pub(crate) fn streamed_segment_tree<const D: usize>() -> Box<dyn Method<D>> {
    let tree = StreamedSegmentTree::default();
    method("StreamedSegmentTree", [0, 90, 181], tree)
}

/// The methods of the paper and ours, the slowest first.
pub(crate) fn all<const D: usize>() -> Vec<Box<dyn Method<D>>> {
    vec![
        method("SweepAndPrune", [60, 60, 60], SweepAndPrune::default()),
        method(
            "CoherentSweepAndPrune",
            [160, 160, 160],
            CoherentSweepAndPrune::default(),
        ),
        streamed_segment_tree(),
        method(
            "StreamedSegmentTree, best cutoff",
            [80, 170, 230],
            StreamedSegmentTree::with_cutoff(BEST_CUTOFF),
        ),
        dual_axis_sweep(),
        rank_sweep(),
        grid_sweep(),
    ]
}
