//! What a study puts out: tables in Markdown, rows in JSON, charts in SVG.

use crate::RAPIER;
use crate::options::Common;
use anyhow::{Context, Result};
use comfy_table::presets::ASCII_MARKDOWN;
use comfy_table::{CellAlignment, ColumnConstraint, Table};
use serde::Serialize;
use std::fs::{File, create_dir_all};
use std::io::{BufWriter, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use unisize_charts::Chart;

/// Where the rows and charts of a study go.
pub(crate) struct Output {
    study: &'static str,
    json: Option<BufWriter<File>>,
    charts: Option<PathBuf>,
}

/// A line of the file of rows.
#[derive(Serialize)]
struct Line<'a, T> {
    study: &'static str,
    rapier: &'static str,
    kind: &'static str,
    #[serde(flatten)]
    row: &'a T,
}

impl Output {
    /// Opens what was asked for, before a long run, which a failure would waste.
    pub(crate) fn create(study: &'static str, common: &Common) -> Result<Self> {
        let json = common.json.as_ref().map(|file| {
            let opened = File::create(file).map(BufWriter::new);
            opened.with_context(|| format!("cannot write {}", file.display()))
        });
        if let Some(folder) = &common.chart {
            create_dir_all(folder)
                .with_context(|| format!("cannot create {}", folder.display()))?;
        }
        Ok(Self {
            study,
            json: json.transpose()?,
            charts: common.chart.clone(),
        })
    }

    /// Writes a row of this kind.
    pub(crate) fn row(&mut self, kind: &'static str, row: &impl Serialize) -> Result<()> {
        if let Some(json) = &mut self.json {
            let line = Line {
                study: self.study,
                rapier: RAPIER,
                kind,
                row,
            };
            serde_json::to_writer(&mut *json, &line)?;
            writeln!(json)?;
            json.flush()?;
        }
        Ok(())
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
        println!("Drawn: {}\n", file.display());
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

/// A table whose first column is text and whose others are figures.
pub(crate) fn table<T: Into<comfy_table::Row>>(head: T) -> Table {
    let mut table = Table::new();
    table.load_preset(ASCII_MARKDOWN).set_header(head);
    for column in table.column_iter_mut() {
        // However wide the terminal is: a line of Markdown must not be broken.
        column.set_constraint(ColumnConstraint::ContentWidth);
        if column.index > 0 {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table
}

/// A number with three digits that count.
pub(crate) fn number(value: f64) -> String {
    if value.is_nan() {
        return "-".to_owned();
    }
    if value == 0.0 || value.is_infinite() {
        return value.to_string();
    }
    let power = value.abs().log10().floor() as i32;
    match power {
        -3..=5 => format!("{value:.*}", (2 - power).max(0) as usize),
        _ => format!("{value:.1e}"),
    }
}

/// A share in percent.
pub(crate) fn percent(share: f64) -> String {
    match share {
        0.0 => "none".to_owned(),
        _ => format!("{} %", number(100.0 * share)),
    }
}

#[cfg(test)]
mod tests {
    use super::{number, percent};

    #[test]
    fn three_digits_count() {
        let numbers = [0.0, 0.00123456, 0.5, 12.3456, 1234.5, 1.0e-6, f64::NAN];
        let texts = numbers.map(number);
        let expected = ["0", "0.00123", "0.500", "12.3", "1234", "1.0e-6", "-"];
        assert_eq!(texts, expected);
        assert_eq!([0.0, 0.5].map(percent), ["none", "50.0 %"]);
    }
}
