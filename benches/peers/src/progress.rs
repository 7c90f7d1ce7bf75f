//! A progress bar, on a terminal only.

use indicatif::{ProgressBar, ProgressStyle};
use std::time::Duration;

/// Which case is being measured.
pub(crate) struct Progress(ProgressBar);

impl Progress {
    /// Hidden unless standard error is a terminal.
    pub(crate) fn new() -> Self {
        let bar = ProgressBar::no_length();
        let style = ProgressStyle::with_template("{elapsed_precise} {bar:30} {pos}/{len} {msg}");
        bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        // Drawn twice a second: more would take time from what is measured.
        bar.enable_steady_tick(Duration::from_millis(500));
        Self(bar)
    }

    /// So many cases more.
    pub(crate) fn expect(&self, cases: usize) {
        self.0.inc_length(cases as u64);
    }

    /// The case that begins.
    pub(crate) fn begin(&self, case: String) {
        self.0.set_message(case);
    }

    /// The case is over.
    pub(crate) fn end(&self) {
        self.0.inc(1);
    }

    pub(crate) fn finish(&self) {
        self.0.finish_and_clear();
    }
}
