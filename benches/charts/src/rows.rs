//! What was measured: the rows of a file in `benches/results`.

use anyhow::{Context, Result, bail};
use serde_json::Value;
use std::path::Path;

/// A line of a file: fields by name.
pub(crate) struct Row(Value);

impl Row {
    /// The rows of `RESULTS/MACHINE/NAME.jsonl`, of whichever machine, without those that say how they were measured.
    pub(crate) fn read(results: &Path, name: &str) -> Result<Vec<Self>> {
        let mut files = Vec::new();
        for machine in results.read_dir().context("no results")? {
            let file = machine?.path().join(format!("{name}.jsonl"));
            files.extend(file.exists().then_some(file));
        }
        let [file] = &files[..] else {
            bail!(
                "{} files of the name {name}.jsonl in place of one",
                files.len()
            );
        };
        let text = std::fs::read_to_string(file)?;
        let rows = text.lines().map(serde_json::from_str);
        let rows = rows.collect::<Result<Vec<Value>, _>>();
        let rows = rows.with_context(|| format!("{}", file.display()))?;
        let rows = rows.into_iter().filter(|row| row.get("command").is_none());
        Ok(rows.map(Self).collect())
    }

    pub(crate) fn is(&self, field: &str, value: impl Into<Value>) -> bool {
        self.0.get(field) == Some(&value.into())
    }

    pub(crate) fn text(&self, field: &str) -> Result<&str> {
        self.get(field, Value::as_str)
    }

    pub(crate) fn number(&self, field: &str) -> Result<f64> {
        self.get(field, Value::as_f64)
    }

    fn get<'a, T>(&'a self, field: &str, read: impl Fn(&'a Value) -> Option<T>) -> Result<T> {
        let value = self.0.get(field).and_then(read);
        value.with_context(|| format!("no {field} in {}", self.0))
    }
}
