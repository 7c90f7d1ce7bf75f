//! The kernels of this repository.

use super::cgal::{CUTOFFS, DEFAULT_CUTOFF};
use super::contender::{Family, Kernel, Setting};
use super::frame::Frame;
use anyhow::Result;
use std::borrow::Cow;
use unisize::{GridSweep, PairFinder, RankSweep};
use unisize_reference::StreamedSegmentTree;

pub(super) const STREAMED_AT_DEFAULT_CUTOFF: &str = "unisize StreamedSegmentTree, default cutoff";

pub(super) const STREAMED_AT_BEST_CUTOFF: &str = "unisize StreamedSegmentTree, best cutoff";

/// GridSweep, which all ratios are relative to, and RankSweep, up to so many boxes.
pub(crate) fn families<const D: usize>(rank_sweep_max: usize) -> Vec<Family<D>> {
    let mut rank_sweep = Family::new("unisize RankSweep", [setting::<RankSweep<f32, D>, D>()]);
    rank_sweep.max_count = rank_sweep_max;
    vec![
        Family::new("unisize GridSweep", [setting::<GridSweep<f32, D>, D>()]),
        rank_sweep,
    ]
}

/// StreamedSegmentTree, CGAL's algorithm, with the very settings that CGAL has.
pub(crate) fn streamed_families<const D: usize>() -> Vec<Family<D>> {
    let setting = |cutoff| {
        Setting::new(format!("cutoff {cutoff}"), move || {
            Ok(Ours {
                finder: StreamedSegmentTree::<f32, D>::with_cutoff(cutoff),
                pairs: Vec::new(),
            })
        })
    };
    vec![
        Family::new(STREAMED_AT_DEFAULT_CUTOFF, [setting(DEFAULT_CUTOFF)]),
        Family::new(STREAMED_AT_BEST_CUTOFF, CUTOFFS.map(setting)),
    ]
}

fn setting<F: PairFinder<f32, D> + Default + 'static, const D: usize>() -> Setting<D> {
    Setting::new("", || Ok(Ours::<F>::default()))
}

#[derive(Default)]
struct Ours<F> {
    finder: F,
    pairs: Vec<[u32; 2]>,
}

impl<F: PairFinder<f32, D>, const D: usize> Kernel<D> for Ours<F> {
    fn find_pairs(&mut self, frame: &Frame<D>) -> Result<()> {
        self.finder.find_pairs(&frame.boxes, &mut self.pairs)?;
        Ok(())
    }

    fn pairs(&self) -> Cow<'_, [[u32; 2]]> {
        Cow::Borrowed(&self.pairs)
    }
}
