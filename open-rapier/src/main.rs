//! Patches Rapier 0.36.1 so that it accepts other broad phases than its own: copies the sources that Cargo has fetched, edits the copies,
//! and makes the project use them.

mod manifest;
mod members;
mod note;
mod patched_copy;
mod project;
mod seam;

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use clap::Parser;

use manifest::{Entry, Manifest};
use patched_copy::PatchedCopy;
use project::Project;
use seam::VERSION;

/// Patches Rapier 0.36.1 so that it accepts other broad phases than its own.
///
/// Copies the sources of rapier2d, rapier3d, rapier2d-f64 and rapier3d-f64 that a project uses, as Cargo has fetched them. Adds a trait
/// `CustomBroadPhase` and a constructor `BroadPhaseBvh::custom` to the copies, and prints the lines by which the project uses them. A
/// copy that an earlier run has made is replaced if it differs.
#[derive(Parser)]
#[command(version)]
struct Options {
    /// The folder for the copies, each in a folder with the name of its package
    #[arg(long, value_name = "DIR")]
    out: PathBuf,

    /// The manifest of the project that uses Rapier
    #[arg(long, value_name = "PATH", default_value = "Cargo.toml")]
    manifest_path: PathBuf,

    /// Write the lines into the manifest of the workspace, instead of printing them
    #[arg(long)]
    write: bool,

    /// Write nothing, and fail if a copy is not exactly as this program would make it
    #[arg(long, conflicts_with = "write")]
    check: bool,

    /// Remove the copies, and their lines in the manifest of the workspace
    #[arg(long, conflicts_with_all = ["write", "check"])]
    undo: bool,
}

fn main() -> Result<()> {
    let options = Options::parse();
    let out = manifest::normal(&options.out);
    if options.undo {
        return undo(&options, &out);
    }
    let project = Project::find(&options.manifest_path, &out)?;
    let copies = project.sources.iter();
    let copies = copies.map(|(package, sources)| PatchedCopy::new(package, sources));
    let copies: Vec<_> = copies.collect::<Result<_>>()?;
    if options.check {
        check(&copies, &out)
    } else {
        patch(project, &copies, &out, options.write)
    }
}

/// Fails if a copy on disk differs, and lists the differences.
fn check(copies: &[PatchedCopy], out: &Path) -> Result<()> {
    let mut differences = vec![];
    for copy in copies {
        differences.extend(copy.differences(&out.join(copy.package))?);
    }
    ensure!(
        differences.is_empty(),
        "not as open-rapier would make it:\n{}",
        differences.join("\n")
    );
    print_places(copies, out);
    Ok(())
}

fn print_places(copies: &[PatchedCopy], out: &Path) {
    for PatchedCopy { package, .. } in copies {
        let place = out.join(package);
        eprintln!("{package} {VERSION} is patched in {}", place.display());
    }
}

/// Writes the copies that differ, and the manifest, once nothing is left that may be refused.
fn patch(mut project: Project, copies: &[PatchedCopy], out: &Path, write: bool) -> Result<()> {
    let packages: Vec<_> = copies.iter().map(|copy| copy.package).collect();
    let mut outdated = vec![];
    for copy in copies {
        let place = out.join(copy.package);
        patched_copy::ensure_free(&place)?;
        // A copy that is up to date keeps its dates, so that Cargo does not compile it again.
        if !copy.differences(&place)?.is_empty() {
            outdated.push(copy);
        }
    }
    let lines = project.manifest.lines(&packages, out);
    let mut elsewhere = project.manifest.entries(out);
    elsewhere.retain(|entry| packages.contains(&entry.package) && !entry.leads_to(out));
    let changed = write && project.manifest.set(&packages, out)?;

    patched_copy::place(&outdated, out)?;
    print_places(copies, out);
    if changed {
        project.manifest.write(&project.manifest.text())?;
        eprintln!("the manifest now uses these copies");
    } else if !write {
        print!("{lines}");
    }
    for entry in elsewhere {
        let (package, old) = (entry.package, entry.folder.unwrap_or_default());
        let old = old.display();
        if write {
            eprintln!("{old} is no longer used, and can be deleted");
        } else {
            eprintln!("the manifest uses {package} from {old}: replace that line by the new one");
        }
    }
    Ok(())
}

/// Removes what earlier runs have written. It asks Cargo only where the manifest is, so it also works in a project that does not build.
fn undo(options: &Options, out: &Path) -> Result<()> {
    let mut manifest = project::manifest(&options.manifest_path)?;
    let path = manifest.path.display().to_string();
    // An entry whose copy is missing is ours. One that leads to a folder of the user's is not.
    let is_ours = |entry: &Entry| {
        entry.leads_to(out) && patched_copy::ensure_free(&out.join(entry.package)).is_ok()
    };
    let entries = manifest.entries(out).into_iter();
    let (ours, others): (Vec<_>, Vec<_>) = entries.partition(is_ours);
    let copies: Vec<_> = patched_copy::found(out).collect();
    if !ours.is_empty() {
        // First, because a manifest whose copies are missing is an error for Cargo.
        let text = manifest.without(&ours)?;
        manifest.write(&text)?;
        for Entry { key, .. } in &ours {
            eprintln!("removed {key} below [patch.crates-io] from {path}");
        }
        if Manifest::read(&manifest.path)?.patch().is_none() {
            eprintln!("removed [patch.crates-io] from {path}: it was empty");
        }
    }
    for place in &copies {
        let at = place.display();
        fs::remove_dir_all(place).with_context(|| format!("cannot remove {at}"))?;
        eprintln!("removed the folder {at}");
    }
    let at = out.display();
    if ours.is_empty() && copies.is_empty() {
        eprintln!("nothing to undo: {path} uses no copy in {at}, and there is none");
    } else if fs::remove_dir(&options.out).is_ok() {
        // It was empty. A link stays, and so does the folder in which the program runs.
        eprintln!("removed the folder {at}");
    }
    for entry in others {
        let (package, folder) = (entry.package, entry.folder.unwrap_or_default());
        let folder = folder.display();
        eprintln!(
            "{path} still uses {package} from {folder}, which open-rapier has not made in {at}"
        );
    }
    Ok(())
}
