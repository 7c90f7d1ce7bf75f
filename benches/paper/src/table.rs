//! All figures, in one table: a part of the page, a row, a column, and a number or a verdict.

use anyhow::{Context, Result};
use serde::Serialize;
use serde_json::Value;
use std::fmt::{self, Display};
use std::fs;
use std::path::Path;
use unisize_report::JsonLines;

/// One figure.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Figure {
    /// The table that it belongs to.
    part: &'static str,
    row: String,
    column: String,
    /// A number or a verdict.
    value: Value,
}

/// All figures, in the order in which they were found.
#[derive(Clone, Debug, Default)]
pub(crate) struct Table(Vec<Figure>);

impl Table {
    pub(crate) fn add(
        &mut self,
        part: &'static str,
        row: impl Into<String>,
        column: impl Into<String>,
        value: impl Into<Value>,
    ) {
        self.0.push(Figure {
            part,
            row: row.into(),
            column: column.into(),
            value: value.into(),
        });
    }

    /// The number in a cell, if there is one.
    pub(crate) fn number(&self, part: &str, row: &str, column: &str) -> Option<f64> {
        let is_it = |f: &&Figure| f.part == part && f.row == row && f.column == column;
        self.0.iter().find(is_it)?.value.as_f64()
    }

    /// The names of the tables.
    fn parts(&self) -> Vec<&'static str> {
        different(self.0.iter().map(|figure| figure.part))
    }

    /// One table in Markdown.
    fn markdown(&self, part: &str) -> String {
        let figures: Vec<_> = self.0.iter().filter(|f| f.part == part).collect();
        let columns = different(figures.iter().map(|f| &f.column[..]));
        let mut text = format!(
            "| | {} |\n|---|{}\n",
            columns.join(" | "),
            "--:|".repeat(columns.len())
        );
        for row in different(figures.iter().map(|f| &f.row[..])) {
            text += &format!("| {row} |");
            for &column in &columns {
                let cell = figures.iter().find(|f| f.row == row && f.column == column);
                text += &match cell.map(|figure| &figure.value) {
                    Some(Value::String(words)) => format!(" {words} |"),
                    Some(value) => format!(" {} |", digits(value.as_f64().unwrap_or(f64::NAN))),
                    None => " |".to_owned(),
                };
            }
            text.push('\n');
        }
        text
    }

    /// Appends a line for each figure to this file, if there is one.
    pub(crate) fn append_to(&self, file: Option<&Path>) -> Result<()> {
        let mut lines = JsonLines::append(file)?;
        for figure in &self.0 {
            lines.write(figure)?;
        }
        Ok(())
    }

    /// Replaces the tables of a page by these. A page may leave some out.
    pub(crate) fn write_into(&self, page: &Path) -> Result<()> {
        let cannot = || format!("cannot change {}", page.display());
        let mut text = fs::read_to_string(page).with_context(cannot)?;
        for part in self.parts() {
            if text.contains(&format!("<!-- begin {part} -->\n")) {
                text = replaced(&text, part, &self.markdown(part)).with_context(cannot)?;
            }
        }
        fs::write(page, text).with_context(cannot)
    }
}

impl Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let parts = self.parts();
        let mut tables = parts.iter().map(|part| (part, self.markdown(part)));
        tables.try_for_each(|(part, table)| writeln!(f, "{part}\n\n{table}"))
    }
}

/// The different ones, in the order in which they come.
fn different<'a>(names: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut different = Vec::new();
    for name in names {
        if !different.contains(&name) {
            different.push(name);
        }
    }
    different
}

/// The text with another block between the two comments of this name.
fn replaced(text: &str, name: &str, block: &str) -> Result<String> {
    let [begin, end] = ["begin", "end"].map(|which| format!("<!-- {which} {name} -->\n"));
    let no_place = || format!("there is no place for {name}");
    let (before, rest) = text.split_once(&begin).with_context(no_place)?;
    let (_, after) = rest.split_once(&end).with_context(no_place)?;
    Ok([before, &begin, block, &end, after].concat())
}

/// A number with three significant digits, or a whole one with more.
pub(crate) fn digits(x: f64) -> String {
    if !x.is_finite() {
        return "–".to_owned();
    }
    if x == 0.0 {
        return "0".to_owned();
    }
    // A little more, so that a number that is rounded up to a power of ten counts as one.
    let magnitude = (x.abs() * 1.0005).log10().floor() as i32;
    match magnitude {
        -3.. => format!("{x:.*}", (2 - magnitude).max(0) as usize),
        _ => format!("{x:.1e}"),
    }
}

/// A power of two as such, any other number in full.
pub(crate) fn count(n: usize) -> String {
    if !n.is_power_of_two() || n < 1024 {
        return n.to_string();
    }
    format!("2<sup>{}</sup>", n.ilog2())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_is_a_table() {
        let mut table = Table::default();
        table.add("a", "first", "ms", 2.0);
        table.add("b", "other", "ms", 9.0);
        table.add("a", "second", "pairs", 1234_usize);
        table.add("a", "first", "verdict", "yes");
        let expected = "| | ms | pairs | verdict |\n|---|--:|--:|--:|\n\
            | first | 2.00 | | yes |\n| second | | 1234 | |\n";
        assert_eq!(table.markdown("a"), expected);
        assert_eq!(table.number("a", "first", "ms"), Some(2.0));
        assert_eq!(table.number("a", "first", "verdict"), None);
    }

    #[test]
    fn numbers_have_three_digits() {
        let expected = ["1234", "100", "12.3", "1.00", "0.0123", "0.00123", "–", "0"];
        let numbers = [1234.4, 99.96, 12.34, 1.0, 0.0123, 0.00123, f64::NAN, 0.0];
        for (x, text) in numbers.iter().zip(expected) {
            assert_eq!(digits(*x), text);
        }
        assert_eq!(count(1 << 20), "2<sup>20</sup>");
        assert_eq!(count(100_000), "100000");
    }

    #[test]
    fn a_block_replaces_what_was_there() {
        let text = "a\n<!-- begin x -->\nold\n<!-- end x -->\nb\n";
        let new = replaced(text, "x", "new\n").unwrap();
        assert_eq!(new, "a\n<!-- begin x -->\nnew\n<!-- end x -->\nb\n");
        assert!(replaced(text, "y", "").is_err());
    }
}
