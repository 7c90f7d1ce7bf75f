//! The result of one comparison, the same type for both dimensions.

use crate::case::Case;
use crate::options::Options;
use serde::Serialize;
use unisize_scenes::Outcome;

/// The result of comparing in one case in one dimension.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Row {
    /// The version.
    rapier: &'static str,
    pub(super) scene: String,
    pub(super) dim: u8,
    /// The number of steps before whole steps were timed.
    before: usize,
    filter: String,
    threads: usize,
    pub(super) equal: bool,
    #[serde(flatten)]
    pub(super) outcome: Outcome,
}

impl Row {
    pub(super) fn new(case: Case, dim: u8, options: &Options, outcome: Outcome) -> Self {
        Self {
            rapier: crate::RAPIER,
            scene: case.name(),
            dim,
            before: options.before(),
            filter: options.filter.clone(),
            threads: options.threads,
            equal: outcome.is_equal(),
            outcome,
        }
    }
}
