//! The methods that find pairs: the paper's, those that it is compared with, and ours.

use unisize::{GridSweep, PairFinder, RankSweep};
use unisize_charts::{RGBColor, color};
use unisize_reference::SweepAndPrune;

/// A contestant of a race.
pub(crate) struct Method<const D: usize> {
    pub(crate) name: &'static str,
    /// The colour of its lines.
    pub(crate) color: RGBColor,
    pub(crate) finder: Box<dyn PairFinder<f32, D>>,
}

fn method<const D: usize>(
    name: &'static str,
    color: RGBColor,
    finder: impl PairFinder<f32, D> + 'static,
) -> Method<D> {
    let finder = Box::new(finder);
    Method {
        name,
        color,
        finder,
    }
}

/// The methods of the paper and ours.
pub(crate) fn all<const D: usize>() -> Vec<Method<D>> {
    vec![
        method("SweepAndPrune", color::BLACK, SweepAndPrune::default()),
        method("RankSweep", color::SALMON, RankSweep::default()),
        method("GridSweep", color::RED, GridSweep::default()),
    ]
}
