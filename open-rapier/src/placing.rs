//! Puts copies in their places, once all are complete, and never over anything that this tool has not made.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail};

use crate::note;
use crate::opened_copy::OpenedCopy;

/// Fails if there is something else where a copy is to be.
pub(crate) fn ensure_free(place: &Path) -> Result<()> {
    let Ok(metadata) = fs::symlink_metadata(place) else {
        return Ok(());
    };
    let empty = || fs::read_dir(place).is_ok_and(|mut entries| entries.next().is_none());
    if !metadata.is_dir() || !(note::is_ours(place) || empty()) {
        bail!(
            "{} was not made by open-rapier, and is left as it is: move it, or choose another --out",
            place.display()
        );
    }
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
