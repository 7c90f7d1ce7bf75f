//! Keeps copies out of the workspace. A copy that is a member adds the dependencies of its own tests to the lock file, and hides the sources
//! that it was made from.

use std::path::{Component, Path, PathBuf};

use anyhow::{Result, bail};
use glob::{MatchOptions, Pattern};

use crate::manifest::{Manifest, normal};
use crate::note;

/// Cargo's rules: a wildcard matches within one name of a path.
const OPTIONS: MatchOptions = MatchOptions {
    case_sensitive: true,
    require_literal_separator: true,
    require_literal_leading_dot: false,
};

/// Fails if Cargo would regard a copy, or a folder that is created for it, as a member.
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
        // A folder that has a manifest already, and is no copy, does not change.
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
    // Cargo's rule: a folder below an entry of `members` is not excluded.
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
        // Excluding does not help: Cargo demands that default members are members.
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

/// The path of an entry below the root, without `.` and `..`.
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
