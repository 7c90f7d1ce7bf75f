//! The kernels of this repository.

use super::contender::{Family, Setting};
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
    Setting::listing("", || {
        let mut finder = F::default();
        move |frame, pairs| Ok(finder.find_pairs(&frame.boxes, pairs)?)
    })
}
