//! The rows as tables in Markdown: a line for each contender, a column for each number of boxes.

use crate::row::Row;

/// Prints a table for each dimension, density and motion.
pub(crate) fn print(rows: &[Row]) {
    for table in rows.chunk_by(Row::is_in_series_with) {
        print_one(table);
    }
}

fn print_one(rows: &[Row]) {
    let Some(first) = rows.first() else { return };
    let figure = match &*first.subject {
        "kernels" => "milliseconds and ratio to unisize",
        _ => "milliseconds (mean / longest), ratio to unisize and held pairs",
    };
    let motion = if first.motion.is_empty() {
        String::new()
    } else {
        format!(", {}", first.motion)
    };
    println!(
        "### {}, {}D, density {}{motion}: {figure}\n",
        first.subject, first.dimension, first.density,
    );

    let mut counts = Vec::new();
    let mut contenders = Vec::new();
    for row in rows {
        if !counts.contains(&row.count) {
            counts.push(row.count);
        }
        if !contenders.contains(&&*row.contender) {
            contenders.push(&*row.contender);
        }
    }
    let titles: Vec<_> = counts.iter().map(|count| format!("n = {count}")).collect();
    println!("| | {} |", titles.join(" | "));
    println!("|---|{}", "---|".repeat(counts.len()));
    for contender in contenders {
        let cells = counts.iter().map(|&count| {
            let mut rows = rows.iter();
            let row = rows.find(|row| row.contender == contender && row.count == count);
            row.map_or_else(|| "–".to_owned(), cell)
        });
        let cells: Vec<_> = cells.collect();
        println!("| {contender} | {} |", cells.join(" | "));
    }
    println!();
}

fn cell(row: &Row) -> String {
    let ratio = format!("×{}", significant(row.ratio));
    if row.subject == "kernels" {
        let setting = match row.setting.as_str() {
            "" => String::new(),
            setting => format!(" ({setting})"),
        };
        return format!("{} {ratio}{setting}", significant(row.time_ms()));
    }
    format!(
        "{} / {} {ratio}, {}",
        significant(row.time_ms()),
        significant(row.worst_ms),
        row.pairs
    )
}

/// Three significant digits, no exponent.
pub(crate) fn significant(number: f64) -> String {
    let decimals = match number.abs() {
        x if x >= 100.0 => 0,
        x if x >= 10.0 => 1,
        x if x >= 1.0 => 2,
        x if x >= 0.1 => 3,
        x if x >= 0.01 => 4,
        _ => 5,
    };
    format!("{number:.decimals$}")
}
