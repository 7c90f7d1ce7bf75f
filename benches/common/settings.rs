//! How long Criterion measures.

use crate::common;
use criterion::Criterion;
use std::time::Duration;

/// Ten short samples a figure, so that a whole bench takes a few minutes; arguments on the command line
/// come before this.
pub(crate) fn criterion() -> Criterion {
    common::set_threads();
    Criterion::default()
        .without_plots()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(200))
        .measurement_time(Duration::from_millis(600))
        .configure_from_args()
}
