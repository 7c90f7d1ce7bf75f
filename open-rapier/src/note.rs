//! What a copy says about itself: a note in its folder, and a line at the head of each file that was changed.

use std::fs;
use std::path::Path;

use crate::seam::{Edit, VERSION};

/// The name of the note.
pub(crate) const FILE: &str = "OPENED.md";

/// How every note begins, whatever the version of the tool.
const HEADING: &str = "# Opened by open-rapier";

/// Whether a folder holds a copy that this tool has made.
pub(crate) fn is_ours(folder: &Path) -> bool {
    fs::read_to_string(folder.join(FILE)).is_ok_and(|text| text.starts_with(HEADING))
}

/// Whether it is one of this package, of the version that is opened now.
pub(crate) fn is_copy(folder: &Path, package: &str) -> bool {
    let this = format!("\nThis is {package} {VERSION}, ");
    is_ours(folder) && fs::read_to_string(folder.join(FILE)).is_ok_and(|text| text.contains(&this))
}

/// The line at the head of a changed file.
pub(crate) fn notice(file: &str) -> String {
    let comment = if file.ends_with(".toml") { "#" } else { "//" };
    format!(
        "{comment} Modified by open-rapier {}: see {FILE}.\n",
        env!("CARGO_PKG_VERSION")
    )
}

/// The note.
pub(crate) fn text(package: &str, files: &[(&str, &str, &str)], edits: &[&Edit]) -> String {
    let added = files.iter().map(|file| (file.0, "added", file.2));
    let this = [(FILE, "added", "this note")];
    let edited = edits
        .iter()
        .map(|edit| (edit.file, "modified", edit.purpose));
    let rows: String = added
        .chain(this)
        .chain(edited)
        .map(|(name, what, purpose)| format!("| `{name}` | {what} | {purpose} |\n"))
        .collect();
    format!(
        "{HEADING} {tool}

This is {package} {VERSION}, from the sources that Cargo has fetched, with the changes below. Everything else is as published, but for
`Cargo.lock` and what Cargo itself had added. The authors of Rapier have no part in the changes.

Do not edit the copy: `open-rapier` makes it anew, and `open-rapier --check` tells whether it is as it was made.

| file | | what for |
|---|---|---|
{rows}
Rapier is licensed under the Apache License, Version 2.0 (`license` in `Cargo.toml`; the text is at
<https://www.apache.org/licenses/LICENSE-2.0>), and so is this copy. What was added may also be used under the MIT license.
",
        tool = env!("CARGO_PKG_VERSION"),
    )
}
