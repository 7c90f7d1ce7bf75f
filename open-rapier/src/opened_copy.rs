//! An opened copy of a package, in memory: every file as it is to be. What is on disk is compared with it, or made from it, once all
//! copies are complete, and never over anything that this tool has not made.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use walkdir::WalkDir;

use crate::note;
use crate::seam::{EDITS, Edit, FACTORY_EDITS, FACTORY_FILES, FILES};

/// What Cargo adds to the sources that it fetches, and what a package does not need.
const LEFT_OUT: [&str; 5] = [
    ".cargo-checksum.json",
    ".cargo-ok",
    ".cargo_vcs_info.json",
    "Cargo.lock",
    "Cargo.toml.orig",
];

/// The files of a copy.
pub(crate) struct OpenedCopy {
    pub(crate) package: &'static str,
    files: BTreeMap<PathBuf, Vec<u8>>,
}

impl OpenedCopy {
    /// Reads the sources of `package` and opens them.
    pub(crate) fn new(package: &'static str, sources: &Path, factory: bool) -> Result<Self> {
        let mut copy = Self {
            package,
            files: read(sources)?,
        };
        for name in LEFT_OUT {
            copy.files.remove(Path::new(name));
        }

        let mut files = FILES.to_vec();
        let mut edits: Vec<&Edit> = EDITS.iter().collect();
        if factory {
            files.extend(FACTORY_FILES);
            edits.extend(FACTORY_EDITS);
        }
        for (name, contents, _) in &files {
            let there = copy.files.insert(name.into(), (*contents).into());
            ensure!(
                there.is_none(),
                "{}: {name} is there already; nothing was written",
                sources.display()
            );
        }
        for edit in &edits {
            copy.edit(edit)
                .with_context(|| format!("{} cannot be opened", sources.display()))?;
        }
        // The licence demands that a modified file says so.
        for edit in &edits {
            let new = files.iter().any(|(name, ..)| *name == edit.file);
            if let Some(contents) = copy.files.get_mut(Path::new(edit.file)).filter(|_| !new) {
                let notice = note::notice(edit.file);
                if !contents.starts_with(notice.as_bytes()) {
                    contents.splice(..0, notice.into_bytes());
                }
            }
        }
        let note = note::text(package, &files, &edits);
        copy.files.insert(note::FILE.into(), note.into_bytes());
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

    /// What is different in a folder: the names of files, each with what is wrong with it.
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
        for name in found.keys().filter(|name| !self.files.contains_key(*name)) {
            differs(name, "not part of the copy");
        }
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

/// Fails if there is something else where a copy is to be.
pub(crate) fn ensure_free(place: &Path) -> Result<()> {
    let Ok(metadata) = fs::symlink_metadata(place) else {
        return Ok(());
    };
    let empty = || fs::read_dir(place).is_ok_and(|mut entries| entries.next().is_none());
    ensure!(
        metadata.is_dir() && (note::is_ours(place) || empty()),
        "{} was not made by open-rapier, and is left as it is: move it, or choose another --out",
        place.display()
    );
    Ok(())
}

/// Writes the copies next to their places, and moves them there when all are complete.
pub(crate) fn place(copies: &[&OpenedCopy], out: &Path) -> Result<()> {
    if copies.is_empty() {
        return Ok(());
    }
    fs::create_dir_all(out).with_context(|| format!("cannot make {}", out.display()))?;
    // In the same folder, so that moving is renaming; removed with all that is left in it.
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
