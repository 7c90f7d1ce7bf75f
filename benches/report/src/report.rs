//! What is measured, row by row: a Markdown table on standard output, and the same as JSON in a file.

use crate::json_lines::JsonLines;
use serde::{Serialize, Serializer};
use serde_json::Value;
use std::io;
use std::path::Path;

/// The names and values of a row.
pub type Row<'a> = &'a [(&'a str, Value)];

/// A table on standard output that grows. Rows of other names begin another one.
#[derive(Default)]
pub struct Table {
    head: Vec<String>,
}

impl Table {
    /// Prints a row.
    pub fn row(&mut self, row: Row<'_>) {
        let head: Vec<_> = row.iter().map(|(name, _)| (*name).to_owned()).collect();
        if head != self.head {
            println!("\n| {} |\n|{}", head.join(" | "), "---|".repeat(head.len()));
            self.head = head;
        }
        let cells: Vec<_> = row.iter().map(|(_, value)| shown(value)).collect();
        println!("| {} |", cells.join(" | "));
    }
}

/// A table that is written to a file as well, if there is one.
pub struct Report {
    table: Table,
    lines: JsonLines,
}

impl Report {
    /// Opens the file.
    pub fn new(json: Option<&Path>) -> io::Result<Self> {
        let (table, lines) = (Table::default(), JsonLines::append(json)?);
        Ok(Self { table, lines })
    }

    /// Prints a row, and writes it.
    pub fn row(&mut self, row: Row<'_>) -> io::Result<()> {
        self.table.row(row);
        self.lines.write(&Object(row))
    }
}

struct Object<'a>(Row<'a>);

impl Serialize for Object<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

/// As a cell: no figure has more than three decimals, nor more than four digits that matter.
fn shown(value: &Value) -> String {
    match value {
        Value::Null => "–".to_owned(),
        Value::String(words) => words.clone(),
        Value::Number(number) if number.is_f64() => {
            let number = number.as_f64().unwrap_or(f64::NAN);
            let decimals = match number.abs() {
                x if x >= 1000.0 => 0,
                x if x >= 100.0 => 1,
                x if x >= 10.0 => 2,
                _ => 3,
            };
            format!("{number:.decimals$}")
        }
        other => other.to_string(),
    }
}
