//! `[patch.crates-io]` of the workspace's manifest: what it says of Rapier, and the lines that lead to the copies.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use toml_edit::{DocumentMut, InlineTable, Item, Table, TableLike, Value};

use crate::seam::PACKAGES;

/// The manifest of a workspace.
pub(crate) struct Manifest {
    path: PathBuf,
    document: DocumentMut,
}

/// An entry of the patch that is for one of Rapier's packages.
pub(crate) struct Entry {
    pub(crate) key: String,
    pub(crate) package: &'static str,
    /// Where it leads to, if that is a folder.
    pub(crate) folder: Option<PathBuf>,
}

impl Manifest {
    pub(crate) fn read(path: &Path) -> Result<Self> {
        let text =
            fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))?;
        let document = text
            .parse()
            .with_context(|| format!("{}", path.display()))?;
        Ok(Self {
            path: path.to_owned(),
            document,
        })
    }

    /// The entries for Rapier.
    pub(crate) fn entries(&self) -> Vec<Entry> {
        let patch = self
            .document
            .get("patch")
            .and_then(|patch| patch.get("crates-io"));
        let Some(patch) = patch.and_then(Item::as_table_like) else {
            return vec![];
        };
        let entry = |(key, item): (&str, &Item)| {
            let name = item.get("package").and_then(Item::as_str).unwrap_or(key);
            let folder = item.get("path").and_then(Item::as_str);
            Some(Entry {
                key: key.to_owned(),
                package: PACKAGES.into_iter().find(|package| *package == name)?,
                folder: folder.map(|folder| self.folder().join(folder)),
            })
        };
        patch.iter().filter_map(entry).collect()
    }

    /// The lines that are needed for copies in `out`.
    pub(crate) fn lines(&self, packages: &[&str], out: &Path) -> String {
        let line = |package: &&str| format!("{package} = {}\n", self.entry(package, out));
        format!(
            "[patch.crates-io]\n{}",
            packages.iter().map(line).collect::<String>()
        )
    }

    /// Adds the entries that are missing, and tells whether there were any.
    pub(crate) fn add(&mut self, packages: &[&str], out: &Path) -> Result<bool> {
        let mut missing = vec![];
        for package in packages {
            let mut entries = self
                .entries()
                .into_iter()
                .filter(|entry| entry.package == *package);
            match entries.next().map(|entry| entry.folder) {
                None => missing.push((*package, self.entry(package, out))),
                Some(Some(folder)) if normal(&folder) == out.join(package) => {}
                Some(_) => bail!(
                    "{}: {package} is patched already, and not by {}",
                    self.path.display(),
                    out.join(package).display()
                ),
            }
        }
        let Some(patch) = self.table() else {
            bail!("{}: `patch.crates-io` is not a table", self.path.display());
        };
        for (package, entry) in &missing {
            patch.insert(package, Item::Value(entry.clone()));
        }
        Ok(!missing.is_empty())
    }

    /// Writes the manifest: a new file in its place, so that it is never half of one.
    pub(crate) fn write(&self) -> Result<()> {
        let cannot = || format!("cannot write {}", self.path.display());
        let file = tempfile::NamedTempFile::new_in(self.folder()).with_context(cannot)?;
        fs::write(&file, self.document.to_string()).with_context(cannot)?;
        let permissions = fs::metadata(&self.path).with_context(cannot)?.permissions();
        fs::set_permissions(&file, permissions).with_context(cannot)?;
        file.persist(&self.path).with_context(cannot)?;
        Ok(())
    }

    fn folder(&self) -> &Path {
        self.path.parent().unwrap_or(Path::new(""))
    }

    /// `[patch.crates-io]`, made if it is not there.
    fn table(&mut self) -> Option<&mut dyn TableLike> {
        let mut empty = Table::new();
        empty.set_implicit(true);
        let patch = self.document.entry("patch").or_insert(Item::Table(empty));
        let registry = patch.as_table_like_mut()?.entry("crates-io");
        registry
            .or_insert(Item::Table(Table::new()))
            .as_table_like_mut()
    }

    fn entry(&self, package: &str, out: &Path) -> Value {
        let folder = out.join(package);
        let path = pathdiff::diff_paths(&folder, normal(self.folder())).unwrap_or(folder);
        let path = path
            .to_string_lossy()
            .replace(std::path::MAIN_SEPARATOR, "/");
        let mut table = InlineTable::new();
        table.insert("path", path.into());
        Value::InlineTable(table)
    }
}

/// The absolute path, with no links and no `..` in it, of what need not exist.
pub(crate) fn normal(path: &Path) -> PathBuf {
    if let Ok(path) = path.canonicalize() {
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
