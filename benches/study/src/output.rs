//! What a study puts out: rows as tables in Markdown and as lines of JSON, and charts in SVG.

use crate::RAPIER;
use crate::options::Common;
use anyhow::{Context, Result};
use serde_json::Value;
use std::fs::create_dir_all;
use std::path::PathBuf;
use std::process::ExitCode;
use unisize_charts::Chart;
use unisize_report::Report;

/// Where the rows and charts of a study go.
pub(crate) struct Output {
    study: &'static str,
    report: Report,
    charts: Option<PathBuf>,
}

impl Output {
    /// Opens what was asked for, before a long run, which a failure would waste.
    pub(crate) fn create(study: &'static str, common: &Common) -> Result<Self> {
        if let Some(folder) = &common.chart {
            create_dir_all(folder)
                .with_context(|| format!("cannot create {}", folder.display()))?;
        }
        Ok(Self {
            study,
            report: Report::new(common.json.as_deref()).context("cannot write the rows")?,
            charts: common.chart.clone(),
        })
    }

    /// Prints and writes a row of this kind.
    pub(crate) fn row(&mut self, kind: &str, row: &[(&str, Value)]) -> Result<()> {
        let mut all = vec![("rapier", RAPIER.into()), ("kind", kind.into())];
        all.extend_from_slice(row);
        Ok(self.report.row(&all)?)
    }

    /// Draws the chart of the study, or of one dimension.
    pub(crate) fn chart(&self, dim: Option<u8>, chart: impl FnOnce() -> Chart) -> Result<()> {
        let Some(folder) = &self.charts else {
            return Ok(());
        };
        let dim = dim.map_or_else(String::new, |dim| format!("-{dim}d"));
        let rapier = RAPIER.replace('.', "-");
        let file = folder.join(format!("{}{dim}-{rapier}.svg", self.study));
        chart().write_svg(&file)?;
        println!("\nDrawn: {}", file.display());
        Ok(())
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
