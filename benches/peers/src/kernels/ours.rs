//! The kernels of this repository.

use super::contender::{Family, Kernel, Setting};
use super::frame::Frame;
use anyhow::Result;
use unisize::{GridSweep, PairFinder, RankSweep};

/// GridSweep, which all ratios are relative to, and RankSweep, up to so many boxes.
pub(crate) fn families<const D: usize>(rank_sweep_max: usize) -> Vec<Family<D>> {
    let mut rank_sweep = Family::new("unisize RankSweep", [setting::<RankSweep<f32, D>, D>()]);
    rank_sweep.max_count = rank_sweep_max;
    vec![
        Family::new("unisize GridSweep", [setting::<GridSweep<f32, D>, D>()]),
        rank_sweep,
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

    fn pairs(&self) -> &[[u32; 2]] {
        &self.pairs
    }
}
