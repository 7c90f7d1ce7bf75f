//! Runs one comparison: one source, compiled once in each dimension.

use super::{DIM, ours, scenes};
use crate::case::Case;
use crate::options::Options;
use crate::row::Row;
use ours::{Settings, UnisizeBroadPhase};
use scenes::{Candidate, Comparison};
use unisize::PairFilter;

/// The seed of the scenes' randomness; repeats count up from it.
const SEED: u64 = 1;

/// Compares in one case.
pub(crate) fn compare(case: Case, options: &Options) -> Row {
    let comparison = Comparison {
        steps: options.steps(),
        before: options.before(),
        rays: options.rays,
        repeats: options.repeats(),
        threads: options.threads,
        ..Comparison::new(case.kind, options.bodies(case), SEED)
    };
    let filter = candidate(options.pair_filter());
    let candidates = match options.pair_filter() {
        // The default holds all pairs whose boxes overlap. So these have to be equal first.
        PairFilter::Shapes => {
            let boxes = candidate(crate::FILTER_OF_DEFAULT);
            vec![boxes, filter.leaving_out_more()]
        }
        _ => vec![filter],
    };
    let outcome = comparison.run(&candidates);
    Row::new(case, DIM, options, outcome)
}

fn candidate(filter: PairFilter) -> Candidate<UnisizeBroadPhase> {
    let settings = Settings::default().with_filter(filter);
    Candidate::new(
        move || UnisizeBroadPhase::with_settings(settings),
        |ours| ours.pairs().collect(),
        UnisizeBroadPhase::as_query_pipeline,
    )
}
