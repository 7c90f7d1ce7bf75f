//! The manifest of the workspace: its entries for Rapier under `[patch.crates-io]`, and new ones, which lead to the copies.

use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use toml_edit::{Document, DocumentMut, InlineTable, Item, Table, TableLike, Value};

use crate::note;
use crate::seam::PACKAGES;

/// The byte-order mark. `toml_edit` drops it, as it does the line ends of Windows, so both are put back.
const MARK: &str = "\u{feff}";

/// The manifest of a workspace.
pub(crate) struct Manifest {
    pub(crate) path: PathBuf,
    /// The text as read, for its line ends.
    text: String,
    document: DocumentMut,
}

/// An entry under `[patch.crates-io]` for one of Rapier's packages.
pub(crate) struct Entry {
    pub(crate) key: String,
    pub(crate) package: &'static str,
    /// The folder that it leads to, if it has a path.
    pub(crate) folder: Option<PathBuf>,
}

impl Entry {
    /// Whether it leads to a copy of this program's: in `out`, or in any other folder.
    fn is_ours(&self, out: &Path) -> bool {
        let is_copy = |folder: &PathBuf| note::is_copy(folder, self.package);
        self.leads_to(out) || self.folder.as_ref().is_some_and(is_copy)
    }

    pub(crate) fn leads_to(&self, out: &Path) -> bool {
        self.folder.as_deref() == Some(&out.join(self.package))
    }
}

impl Manifest {
    pub(crate) fn read(path: &Path) -> Result<Self> {
        let text =
            fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))?;
        let document = text.strip_prefix(MARK).unwrap_or(&text);
        let document = document
            .parse()
            .with_context(|| format!("{}", path.display()))?;
        Ok(Self {
            path: path.to_owned(),
            text,
            document,
        })
    }

    /// A list of `[workspace]`, such as `members`.
    pub(crate) fn workspace(&self, list: &str) -> Vec<&str> {
        let workspace = self.document.get("workspace");
        let list = workspace.and_then(|workspace| workspace.get(list)?.as_array());
        list.into_iter()
            .flatten()
            .filter_map(Value::as_str)
            .collect()
    }

    /// The entries that lead to copies of this program's, in `out` or elsewhere.
    pub(crate) fn entries(&self, out: &Path) -> Vec<Entry> {
        let entry = |(key, item): (&str, &Item)| {
            let name = item.get("package").and_then(Item::as_str).unwrap_or(key);
            let folder = item.get("path").and_then(Item::as_str);
            Some(Entry {
                key: key.to_owned(),
                package: PACKAGES.into_iter().find(|package| *package == name)?,
                folder: folder.map(|folder| normal(&self.folder().join(folder))),
            })
        };
        let entries = self.patch().into_iter().flat_map(TableLike::iter);
        let entries = entries.filter_map(entry);
        entries.filter(|entry| entry.is_ours(out)).collect()
    }

    /// The lines that make the project use the copies in `out`.
    pub(crate) fn lines(&self, packages: &[&str], out: &Path) -> String {
        let line = |package: &&str| {
            let key = self.key(package, out);
            let entry = self.entry(&key, package, out);
            format!("{key} = {entry}\n")
        };
        format!(
            "[patch.crates-io]\n{}",
            packages.iter().map(line).collect::<String>()
        )
    }

    /// Adds missing entries, and makes the others lead to `out`. Returns whether anything changed.
    pub(crate) fn set(&mut self, packages: &[&str], out: &Path) -> Result<bool> {
        let mut changed = false;
        for package in packages {
            let right = |entry: &Entry| entry.package == *package && entry.leads_to(out);
            if self.entries(out).iter().any(right) {
                continue;
            }
            let key = self.key(package, out);
            let entry = self.entry(&key, package, out);
            let path = self.relative(&out.join(package));
            let Some(patch) = self.table() else {
                bail!("{}: `patch.crates-io` is not a table", self.path.display());
            };
            let item = patch.get_mut(&key).and_then(|item| item.get_mut("path"));
            if let Some(old) = item.and_then(Item::as_value_mut) {
                let decor = old.decor().clone();
                *old = path.into();
                *old.decor_mut() = decor;
            } else {
                patch.insert(&key, Item::Value(entry));
            }
            changed = true;
        }
        Ok(changed)
    }

    /// The text without these entries, and without the table if nothing else is in it. All other lines, comments too, stay byte for byte.
    pub(crate) fn without(&mut self, entries: &[Entry]) -> Result<String> {
        // `DocumentMut` does not know places in the text.
        let document = Document::parse(&*self.text)?;
        let patch = document.get("patch").and_then(|it| it.get("crates-io"));
        if let Some(table) = patch.and_then(Item::as_table) {
            let (ours, mut others): (Vec<_>, Vec<_>) = table
                .iter()
                .partition(|(key, _)| entries.iter().any(|entry| entry.key == *key));
            let mut cuts: Vec<_> = ours.into_iter().flat_map(|it| spans(it.1)).collect();
            // Tables with headers of their own do not need this one's.
            others.retain(|(_, item)| item.as_table().is_none_or(Table::is_dotted));
            if others.is_empty() && !table.is_implicit() {
                let header = table.span().unwrap_or_default();
                // `set` has put an empty line above it.
                let above = self.text[..header.start].lines().next_back();
                cuts.push(header.start - usize::from(above == Some(""))..header.end);
            }
            return Ok(without_lines(&self.text, &cuts));
        }
        // An inline table is part of a line.
        if let Some(table) = self.table() {
            for entry in entries {
                table.remove(&entry.key);
            }
            if table.is_empty() {
                let patch = self.document["patch"].as_table_like_mut();
                patch.and_then(|patch| patch.remove("crates-io"));
            }
        }
        Ok(self.text())
    }

    /// The text with the changes.
    pub(crate) fn text(&self) -> String {
        keep_line_ends(&self.text, &self.document.to_string())
    }

    /// Writes a text to a new file and renames it, so that the manifest is complete at any time. A link stays a link.
    pub(crate) fn write(&self, text: &str) -> Result<()> {
        let cannot = || format!("cannot write {}", self.path.display());
        let path = normal(&self.path);
        let folder = path.parent().unwrap_or(Path::new(""));
        let file = tempfile::NamedTempFile::new_in(folder).with_context(cannot)?;
        fs::write(&file, text).with_context(cannot)?;
        let permissions = fs::metadata(&path).with_context(cannot)?.permissions();
        fs::set_permissions(&file, permissions).with_context(cannot)?;
        file.persist(&path).with_context(cannot)?;
        Ok(())
    }

    pub(crate) fn folder(&self) -> &Path {
        self.path.parent().unwrap_or(Path::new(""))
    }

    /// `[patch.crates-io]`, added if it is missing.
    fn table(&mut self) -> Option<&mut dyn TableLike> {
        let mut empty = Table::new();
        empty.set_implicit(true);
        let patch = self.document.entry("patch").or_insert(Item::Table(empty));
        let registry = patch.as_table_like_mut()?.entry("crates-io");
        registry
            .or_insert(Item::Table(Table::new()))
            .as_table_like_mut()
    }

    /// `[patch.crates-io]`, if there is one.
    pub(crate) fn patch(&self) -> Option<&dyn TableLike> {
        self.document
            .get("patch")?
            .get("crates-io")?
            .as_table_like()
    }

    /// The key of a package's entry, or a new one. If a patch of another version has taken the package's name, `-036` is appended.
    fn key(&self, package: &str, out: &Path) -> String {
        let mut entries = self.entries(out).into_iter();
        if let Some(entry) = entries.find(|entry| entry.package == package) {
            return entry.key;
        }
        let mut key = package.to_owned();
        while self.patch().is_some_and(|patch| patch.contains_key(&key)) {
            key.push_str("-036");
        }
        key
    }

    fn entry(&self, key: &str, package: &str, out: &Path) -> Value {
        let mut table = InlineTable::new();
        if key != package {
            table.insert("package", package.into());
        }
        table.insert("path", self.relative(&out.join(package)).into());
        Value::InlineTable(table)
    }

    /// A path relative to the manifest, with `/` on every platform.
    pub(crate) fn relative(&self, path: &Path) -> String {
        let relative = pathdiff::diff_paths(path, normal(self.folder()));
        let path = relative.as_deref().unwrap_or(path).to_string_lossy();
        path.replace(std::path::MAIN_SEPARATOR, "/")
    }
}

/// The places of an item and of those below it: headers of tables, keys with dots, and values.
fn spans(item: &Item) -> Vec<Range<usize>> {
    let below = item.as_table().into_iter().flat_map(Table::iter);
    let below = below.flat_map(|(_, item)| spans(item));
    item.span().into_iter().chain(below).collect()
}

/// The text without the lines that a cut touches.
fn without_lines(text: &str, cuts: &[Range<usize>]) -> String {
    let mut end = 0;
    let lines = text.split_inclusive('\n').filter(|line| {
        let start = end;
        end += line.len();
        !cuts.iter().any(|cut| cut.start < end && start < cut.end)
    });
    lines.collect()
}

/// The absolute path, without links and `..`. The path need not exist.
pub(crate) fn normal(path: &Path) -> PathBuf {
    // `dunce` leaves out the prefix `\\?\` of Windows, with which a path may have no `/`.
    if let Ok(path) = dunce::canonicalize(path) {
        return path;
    }
    let absolute = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    match (absolute.parent(), absolute.components().next_back()) {
        (Some(parent), Some(std::path::Component::Normal(name))) => normal(parent).join(name),
        (Some(parent), Some(std::path::Component::ParentDir)) => {
            let mut parent = normal(parent);
            parent.pop();
            parent
        }
        _ => absolute,
    }
}

/// `new` with the byte-order mark of `old`, if it has one, and with the line ends of the first line of `old`.
fn keep_line_ends(old: &str, new: &str) -> String {
    let mark = if old.starts_with(MARK) { MARK } else { "" };
    let new = new.replace("\r\n", "\n");
    let first = old.split_inclusive('\n').next();
    match first.is_some_and(|line| line.ends_with("\r\n")) {
        true => format!("{mark}{}", new.replace('\n', "\r\n")),
        false => format!("{mark}{new}"),
    }
}
