//! The methods that find pairs behind one trait: the paper's, those that it is compared with, and ours.

use anyhow::{Context, Result};
use std::time::{Duration, Instant};
use unisize::{Aabb, GridSweep, PairFinder, RankSweep};
use unisize_charts::{RGBColor, color};
use unisize_reference::{CoherentSweepAndPrune, DualAxisSweep, StreamedSegmentTree, SweepAndPrune};

/// The cutoff at which the streamed segment tree is fastest for boxes of one size.
const BEST_CUTOFF: usize = 2000;

/// A contestant of a race.
pub(crate) trait Method<const D: usize> {
    fn name(&self) -> &'static str;

    /// The colour of its lines.
    fn color(&self) -> RGBColor;

    /// Finds the pairs of a frame's boxes, and returns the time.
    fn run(&mut self, boxes: &[Aabb<f32, D>]) -> Result<Duration>;

    /// The number of pairs found.
    fn pair_count(&self) -> usize;

    /// The pairs, unless the method keeps boxes with a margin and so finds more.
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

/// A kernel with a name and a colour.
fn method<F: PairFinder<f32, D> + 'static, const D: usize>(
    name: &'static str,
    color: RGBColor,
    finder: F,
) -> Box<dyn Method<D>> {
    Box::new(Finder {
        name,
        color,
        finder,
        pairs: Vec::new(),
    })
}

pub(crate) fn grid_sweep<const D: usize>() -> Box<dyn Method<D>> {
    method("GridSweep", color::RED, GridSweep::default())
}

pub(crate) fn rank_sweep<const D: usize>() -> Box<dyn Method<D>> {
    method("RankSweep", color::SALMON, RankSweep::default())
}

pub(crate) fn dual_axis_sweep<const D: usize>() -> Box<dyn Method<D>> {
    method("DualAxisSweep", color::OCHRE, DualAxisSweep::default())
}

pub(crate) fn streamed_segment_tree<const D: usize>() -> Box<dyn Method<D>> {
    let tree = StreamedSegmentTree::default();
    method("StreamedSegmentTree", color::BLUE, tree)
}

/// The methods of the paper and ours, the slowest first.
pub(crate) fn all<const D: usize>() -> Vec<Box<dyn Method<D>>> {
    vec![
        method("SweepAndPrune", color::BLACK, SweepAndPrune::default()),
        method(
            "CoherentSweepAndPrune",
            color::GREY,
            CoherentSweepAndPrune::default(),
        ),
        streamed_segment_tree(),
        method(
            "StreamedSegmentTree, best cutoff",
            color::SKY,
            StreamedSegmentTree::with_cutoff(BEST_CUTOFF),
        ),
        dual_axis_sweep(),
        rank_sweep(),
        grid_sweep(),
    ]
}
