//! Tables in Markdown.

use std::fmt::{self, Display};

/// A table; the first column is left-aligned, all others are right-aligned.
#[derive(Clone, Debug)]
pub(crate) struct Table {
    head: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    pub(crate) fn new(head: impl IntoIterator<Item = impl Into<String>>) -> Self {
        Self {
            head: head.into_iter().map(Into::into).collect(),
            rows: Vec::new(),
        }
    }

    pub(crate) fn push(&mut self, row: impl IntoIterator<Item = impl Into<String>>) {
        self.rows.push(row.into_iter().map(Into::into).collect());
    }
}

impl Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let line =
            |f: &mut fmt::Formatter<'_>, cells: &[String]| writeln!(f, "| {} |", cells.join(" | "));
        line(f, &self.head)?;
        let rule = ["|---|", &"--:|".repeat(self.head.len() - 1)].concat();
        writeln!(f, "{rule}")?;
        self.rows.iter().try_for_each(|row| line(f, row))
    }
}

/// A number with three significant digits.
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
    const SUPERSCRIPTS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    if !n.is_power_of_two() || n < 1024 {
        return n.to_string();
    }
    let exponent = n.ilog2().to_string();
    let digit = |c: char| SUPERSCRIPTS[c as usize - '0' as usize];
    format!("2{}", exponent.chars().map(digit).collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_has_a_line_for_each_row() {
        let mut table = Table::new(["n", "ms"]);
        table.push(["1", "2"]);
        assert_eq!(table.to_string(), "| n | ms |\n|---|--:|\n| 1 | 2 |\n");
    }

    #[test]
    fn numbers_have_three_digits() {
        let expected = ["1234", "100", "12.3", "1.00", "0.0123", "0.00123", "–", "0"];
        let numbers = [1234.4, 99.96, 12.34, 1.0, 0.0123, 0.00123, f64::NAN, 0.0];
        for (x, text) in numbers.iter().zip(expected) {
            assert_eq!(digits(*x), text);
        }
        assert_eq!(count(1 << 20), "2²⁰");
        assert_eq!(count(100_000), "100000");
    }
}
