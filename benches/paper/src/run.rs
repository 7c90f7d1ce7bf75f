//! What the parts measure with, and where their rows go.

use serde_json::Value;
use std::collections::HashMap;
use std::io;
use std::path::Path;
use unisize_report::{Report, Row};

/// What the parts measure with, and where their rows go.
pub(crate) struct Run {
    pub(crate) quick: bool,
    report: Report,
    /// By part, row and column.
    figures: HashMap<[String; 3], f64>,
}

impl Run {
    pub(crate) fn new(quick: bool, json: Option<&Path>) -> io::Result<Self> {
        Ok(Self {
            quick,
            report: Report::new(json)?,
            figures: HashMap::new(),
        })
    }

    /// The first in a quick run, otherwise the second.
    pub(crate) fn choose<T>(&self, quick: T, full: T) -> T {
        if self.quick { quick } else { full }
    }

    /// Two to the power of `size`, the number of squares; a quick run has fewer.
    pub(crate) fn squares(&self, size: u32) -> usize {
        self.choose(1 << (size - 7), 1 << size)
    }

    /// Prints and writes a row of a part.
    pub(crate) fn row(&mut self, part: &str, row: &str, columns: Row<'_>) -> io::Result<()> {
        let figures = columns.iter().filter_map(|(column, value)| {
            let place = [part, row, column].map(str::to_owned);
            Some((place, value.as_f64()?))
        });
        self.figures.extend(figures);
        let mut all: Vec<(&str, Value)> = vec![("part", part.into()), ("row", row.into())];
        all.extend_from_slice(columns);
        self.report.row(&all)
    }

    /// The number in a cell, if there is one.
    pub(crate) fn number(&self, part: &str, row: &str, column: &str) -> Option<f64> {
        let place = [part, row, column].map(str::to_owned);
        self.figures.get(&place).copied()
    }
}

/// A power of two as such, any other number in full.
pub(crate) fn count(n: usize) -> String {
    if !n.is_power_of_two() || n < 1024 {
        return n.to_string();
    }
    format!("2<sup>{}</sup>", n.ilog2())
}
