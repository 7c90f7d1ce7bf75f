//! What a study puts out: rows, as tables in Markdown and as lines of JSON.

use crate::RAPIER;
use crate::options::Common;
use anyhow::{Context, Result};
use serde_json::Value;
use std::process::ExitCode;
use unisize_report::Report;

/// Where the rows of a study go.
pub(crate) struct Output(Report);

impl Output {
    /// Opens what was asked for, before a long run, which a failure would waste.
    pub(crate) fn create(common: &Common) -> Result<Self> {
        let report = Report::new(common.json.as_deref());
        Ok(Self(report.context("cannot write the rows")?))
    }

    /// Prints and writes a row of this kind.
    pub(crate) fn row(&mut self, kind: &str, row: &[(&str, Value)]) -> Result<()> {
        let mut all = vec![("rapier", RAPIER.into()), ("kind", kind.into())];
        all.extend_from_slice(row);
        Ok(self.0.row(&all)?)
    }
}

/// Runs a study on one thread: the processor time of a thread stands still while a pool of others works for it.
pub(crate) fn exit_code(study: impl FnOnce() -> Result<bool>) -> ExitCode {
    let threads = rayon::ThreadPoolBuilder::new().num_threads(1);
    let pool = threads.build_global().context("cannot have one thread");
    match pool.and_then(|()| study()) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(2)
        }
    }
}
