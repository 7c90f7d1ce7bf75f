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
    let outcome = if options.pair_filter() == PairFilter::Shapes {
        // The default holds all pairs whose boxes overlap. So these have to be equal first.
        let boxes = Comparison {
            repeats: 0,
            ..comparison
        };
        let boxes = boxes.run(&candidate(crate::FILTER_OF_DEFAULT));
        let shapes = candidate(PairFilter::Shapes).leaving_out_more();
        let mut outcome = comparison.run(&shapes);
        outcome.first_difference = boxes.first_difference.or(outcome.first_difference);
        outcome
    } else {
        comparison.run(&candidate(options.pair_filter()))
    };
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
