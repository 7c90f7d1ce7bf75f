//! A patched copy of a package: all of its files, in memory. The program compares the files on disk with them, or writes them once all copies
//! are complete. It never overwrites a folder that it has not made.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use walkdir::WalkDir;

use crate::note;
use crate::seam::{EDITS, Edit, FILES, PACKAGES};

/// Files that Cargo adds to the sources that it fetches, and files that a package does not need.
const LEFT_OUT: [&str; 5] = [
    ".cargo-checksum.json",
    ".cargo-ok",
    ".cargo_vcs_info.json",
    "Cargo.lock",
    "Cargo.toml.orig",
];

/// The files of a copy.
pub(crate) struct PatchedCopy {
    pub(crate) package: &'static str,
    files: BTreeMap<PathBuf, Vec<u8>>,
}

impl PatchedCopy {
    /// Reads the sources of `package` and patches them.
    pub(crate) fn new(package: &'static str, sources: &Path) -> Result<Self> {
        let mut copy = Self {
            package,
            files: read(sources)?,
        };
        for name in LEFT_OUT {
            copy.files.remove(Path::new(name));
        }
        for (name, contents, _) in FILES {
            let existing = copy.files.insert(name.into(), (*contents).into());
            ensure!(
                existing.is_none(),
                "{}: {name} exists already; nothing was written",
                sources.display()
            );
        }
        for edit in EDITS {
            copy.edit(edit)
                .with_context(|| format!("{} cannot be patched", sources.display()))?;
        }
        // The licence demands that a modified file says so.
        for edit in EDITS {
            if let Some(contents) = copy.files.get_mut(Path::new(edit.file)) {
                let notice = note::notice(edit.file);
                if !contents.starts_with(notice.as_bytes()) {
                    contents.splice(..0, notice.into_bytes());
                }
            }
        }
        let note = note::text(package).into_bytes();
        copy.files.insert(note::FILE.into(), note);
        Ok(copy)
    }

    fn edit(&mut self, edit: &Edit) -> Result<()> {
        let contents = self.files.get_mut(Path::new(edit.file));
        let contents =
            contents.with_context(|| format!("{} is missing; nothing was written", edit.file))?;
        let text =
            std::str::from_utf8(contents).with_context(|| format!("{} is not UTF-8", edit.file))?;
        *contents = edit.apply(text, self.package)?.into_bytes();
        Ok(())
    }

    /// The differences between a folder and this copy: a line for each file that is missing, different or superfluous.
    pub(crate) fn differences(&self, folder: &Path) -> Result<Vec<String>> {
        if !folder.exists() {
            return Ok(vec![format!("{} is missing", folder.display())]);
        }
        let found = read(folder)?;
        let mut differences = vec![];
        let mut differs = |name: &PathBuf, how: &str| {
            differences.push(format!("{} is {how}", folder.join(name).display()));
        };
        for (name, contents) in &self.files {
            match found.get(name) {
                None => differs(name, "missing"),
                Some(other) if other != contents => differs(name, "different"),
                Some(_) => {}
            }
        }
        let superfluous = found.keys().filter(|name| !self.files.contains_key(*name));
        superfluous.for_each(|name| differs(name, "not part of the copy"));
        Ok(differences)
    }

    /// Writes all files into a new folder.
    fn write(&self, folder: &Path) -> Result<()> {
        for (name, contents) in &self.files {
            let path = folder.join(name);
            let parent = path.parent().unwrap_or(folder);
            fs::create_dir_all(parent)
                .with_context(|| format!("cannot make {}", parent.display()))?;
            fs::write(&path, contents)
                .with_context(|| format!("cannot write {}", path.display()))?;
        }
        Ok(())
    }
}

/// Fails if `place` holds anything but an earlier copy.
pub(crate) fn ensure_free(place: &Path) -> Result<()> {
    let Ok(metadata) = fs::symlink_metadata(place) else {
        return Ok(());
    };
    let empty = || fs::read_dir(place).is_ok_and(|mut entries| entries.next().is_none());
    ensure!(
        metadata.is_dir() && (note::is_ours(place) || empty()),
        "{} was not made by open-rapier: move it, or choose another --out; nothing was written",
        place.display()
    );
    Ok(())
}

/// The copies in `out`.
pub(crate) fn found(out: &Path) -> impl Iterator<Item = PathBuf> {
    let places = PACKAGES.into_iter().map(|package| out.join(package));
    places.filter(|place| note::is_ours(place) && !place.is_symlink())
}

/// Writes the copies to a temporary folder in `out`, and moves them to their places once all are complete.
pub(crate) fn place(copies: &[&PatchedCopy], out: &Path) -> Result<()> {
    if copies.is_empty() {
        return Ok(());
    }
    fs::create_dir_all(out).with_context(|| format!("cannot make {}", out.display()))?;
    // In the same file system, so that moving a copy is a rename. Removed with the old copies when it goes out of scope.
    let site = tempfile::Builder::new()
        .prefix(".open-rapier-")
        .tempdir_in(out)
        .with_context(|| format!("cannot write to {}", out.display()))?;
    for copy in copies {
        copy.write(&site.path().join(copy.package))?;
    }

    for copy in copies {
        let place = out.join(copy.package);
        let cannot = || format!("cannot put a copy at {}", place.display());
        if place.exists() {
            let old = site.path().join(format!("{}.old", copy.package));
            fs::rename(&place, old).with_context(cannot)?;
        }
        fs::rename(site.path().join(copy.package), &place).with_context(cannot)?;
    }
    Ok(())
}

/// Reads all files below a folder.
fn read(folder: &Path) -> Result<BTreeMap<PathBuf, Vec<u8>>> {
    let mut files = BTreeMap::new();
    for entry in WalkDir::new(folder) {
        let entry = entry?;
        if !entry.file_type().is_dir() {
            let contents = fs::read(entry.path())
                .with_context(|| format!("cannot read {}", entry.path().display()))?;
            files.insert(entry.path().strip_prefix(folder)?.to_owned(), contents);
        }
    }
    Ok(files)
}
