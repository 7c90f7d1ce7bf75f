//! How the programs that measure tell what they found: as tables in Markdown, as lines of JSON that `.ci/tables` reads, and with a bar that
//! shows how far they are.

mod json_lines;
mod progress;
mod report;

pub use json_lines::JsonLines;
pub use progress::progress_bar;
pub use report::{Report, Row, Table};
