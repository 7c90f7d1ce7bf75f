//! The marks of a patched copy: a note in its folder, and a line at the head of each file that was changed.

use std::fs;
use std::path::Path;

use crate::seam::{EDITS, FILES, VERSION};

/// The name of the note.
pub(crate) const FILE: &str = "PATCHED.md";

/// The first words of every note, whatever the version of this program.
const HEADING: &str = "# Patched by open-rapier";

/// Whether a folder holds a copy that this program has made.
pub(crate) fn is_ours(folder: &Path) -> bool {
    read(folder).is_some()
}

/// Whether a folder holds a copy of this package, in the version that is patched now.
pub(crate) fn is_copy(folder: &Path, package: &str) -> bool {
    let this = format!("\nThis is {package} {VERSION}, ");
    read(folder).is_some_and(|text| text.contains(&this))
}

/// The note in a folder, also under the name and the heading that it had at first.
fn read(folder: &Path) -> Option<String> {
    let names = [(FILE, HEADING), ("OPENED.md", "# Opened by open-rapier")];
    names.into_iter().find_map(|(file, heading)| {
        let text = fs::read_to_string(folder.join(file)).ok();
        text.filter(|text| text.starts_with(heading))
    })
}

/// The line at the head of a changed file.
pub(crate) fn notice(file: &str) -> String {
    let comment = if file.ends_with(".toml") { "#" } else { "//" };
    let tool = env!("CARGO_PKG_VERSION");
    format!("{comment} Modified by open-rapier {tool}: see {FILE}.\n")
}

/// The text of the note.
pub(crate) fn text(package: &str) -> String {
    let added = FILES.iter().map(|file| (file.0, "added", file.2));
    let this = [(FILE, "added", "this note")];
    let edited = EDITS
        .iter()
        .map(|edit| (edit.file, "modified", edit.purpose));
    let rows: String = added
        .chain(this)
        .chain(edited)
        .map(|(name, change, purpose)| format!("| `{name}` | {change} | {purpose} |\n"))
        .collect();
    format!(
        "{HEADING} {tool}

This is {package} {VERSION}, from the sources that Cargo has fetched, with the changes below. Everything else is as published, except for
`Cargo.lock` and the files that Cargo itself adds. The authors of Rapier have no part in the changes.

Do not edit the copy: `open-rapier` replaces it, and `open-rapier --check` fails if it was changed.

| file | change | purpose |
|---|---|---|
{rows}
Rapier is licensed under the Apache License, Version 2.0 (`license` in `Cargo.toml`; the text is at
<https://www.apache.org/licenses/LICENSE-2.0>), and so is this copy. The added parts may also be used under the MIT license.
",
        tool = env!("CARGO_PKG_VERSION"),
    )
}
