//! Keeps copies out of the workspace: as a member, a copy brings what its own tests need into the lock file, and hides the
//! sources that it was made from.

use std::path::{Component, Path, PathBuf};

use anyhow::{Result, bail};
use glob::{MatchOptions, Pattern};

use crate::note;
use crate::patch::{Manifest, normal};

/// A wildcard is for one name, as it is for Cargo.
const OPTIONS: MatchOptions = MatchOptions {
    case_sensitive: true,
    require_literal_separator: true,
    require_literal_leading_dot: false,
};

/// Fails if Cargo would take a copy, or a folder that is made for it, for a member.
pub(crate) fn ensure_none<'a>(
    manifest: &Manifest,
    packages: impl Iterator<Item = &'a str>,
    out: &Path,
) -> Result<()> {
    let root = normal(manifest.folder());
    for place in packages.map(|package| out.join(package)) {
        let folders = place
            .ancestors()
            .take_while(|folder| !root.starts_with(folder));
        // Whatever else has a manifest is not made by us, and is what it was.
        for folder in folders.filter(|at| note::is_ours(at) || !at.join("Cargo.toml").exists()) {
            ensure_no_member(manifest, &root, folder)?;
        }
    }
    Ok(())
}

fn ensure_no_member(manifest: &Manifest, root: &Path, folder: &Path) -> Result<()> {
    let members = manifest.workspace("members");
    let default_members = manifest.workspace("default-members");
    let below = |entry: &&str| folder.starts_with(joined(root, entry));
    // Cargo's rule: what is below an entry of `members` is not excluded.
    let excludable = !members.iter().any(below);
    let excluded = excludable && manifest.workspace("exclude").iter().any(below);
    let escaped = PathBuf::from(Pattern::escape(&root.to_string_lossy()));
    let matches = |entry: &&&str| {
        let pattern = Pattern::new(&joined(&escaped, entry).to_string_lossy());
        pattern.is_ok_and(|pattern| pattern.matches_path_with(folder, OPTIONS))
    };
    let (list, entry, exclude) = match (
        members.iter().find(matches),
        default_members.iter().find(matches),
    ) {
        (Some(entry), _) if !excluded => ("members", entry, excludable),
        // Cargo wants members there, so that it does not help to exclude a folder.
        (None, Some(entry)) => ("default-members", entry, false),
        _ => return Ok(()),
    };
    let exclude = if exclude {
        format!(", or add {:?} to `exclude`", manifest.relative(folder))
    } else {
        String::new()
    };
    bail!(
        "{}: {entry:?} of `{list}` matches {}, but copies cannot be members of the workspace: choose another --out{exclude}; nothing was written",
        manifest.path.display(),
        folder.display()
    )
}

/// An entry from the root, without `.` and `..`.
fn joined(root: &Path, entry: &str) -> PathBuf {
    let mut joined = PathBuf::new();
    for component in root.join(entry).components() {
        match component {
            Component::CurDir => {}
            Component::ParentDir => {
                joined.pop();
            }
            other => joined.push(other),
        }
    }
    joined
}
