//! Opens Rapier 0.36.1 for other broad phases than its own: copies the sources that Cargo has fetched, edits the copies, and has
//! the project take them.

mod members;
mod note;
mod opened_copy;
mod patch;
mod project;
mod seam;

use std::path::{Path, PathBuf};

use anyhow::{Result, ensure};
use clap::Parser;

use opened_copy::OpenedCopy;
use project::Project;
use seam::VERSION;

/// Opens Rapier 0.36.1 for other broad phases than its own.
///
/// Copies the sources of rapier2d, rapier3d, rapier2d-f64 and rapier3d-f64 that a project uses, as Cargo has fetched them, gives
/// the copies a trait `CustomBroadPhase` and a constructor `BroadPhaseBvh::custom`, and prints the lines by which the project
/// takes the copies. A copy that this program has made before is made anew.
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

    /// Write nothing, and fail if a copy is not exactly as it would be made
    #[arg(long, conflicts_with = "write")]
    check: bool,

    /// For tests: have `BroadPhaseBvh::new()` and `default()` ask `BROAD_PHASE_FACTORY`
    #[arg(long)]
    factory: bool,
}

fn main() -> Result<()> {
    let options = Options::parse();
    let out = patch::normal(&options.out);
    let project = Project::find(&options.manifest_path, &out)?;
    let mut copies = vec![];
    for (&package, sources) in &project.sources {
        copies.push(OpenedCopy::new(package, sources, options.factory)?);
    }
    if options.check {
        check(&copies, &out)
    } else {
        open(project, &copies, &out, options.write)
    }
}

/// Tells what is not as it would be made.
fn check(copies: &[OpenedCopy], out: &Path) -> Result<()> {
    let mut differences = vec![];
    for copy in copies {
        differences.extend(copy.differences(&out.join(copy.package))?);
    }
    ensure!(
        differences.is_empty(),
        "not as open-rapier would make it:\n{}",
        differences.join("\n")
    );
    tell(copies, out);
    Ok(())
}

/// Tells where the copies are.
fn tell(copies: &[OpenedCopy], out: &Path) {
    for OpenedCopy { package, .. } in copies {
        let place = out.join(package);
        eprintln!("{package} {VERSION} is open in {}", place.display());
    }
}

/// Makes the copies that are not as they should be, after everything that may fail has been looked at.
fn open(mut project: Project, copies: &[OpenedCopy], out: &Path, write: bool) -> Result<()> {
    let packages: Vec<_> = copies.iter().map(|copy| copy.package).collect();
    let mut outdated = vec![];
    for copy in copies {
        let place = out.join(copy.package);
        opened_copy::ensure_free(&place)?;
        // What is right is left alone, so that Cargo does not compile it again.
        if !copy.differences(&place)?.is_empty() {
            outdated.push(copy);
        }
    }
    let lines = project.manifest.lines(&packages, out);
    let mut elsewhere = project.manifest.entries(out);
    elsewhere.retain(|entry| packages.contains(&entry.package) && !entry.leads_to(out));
    let changed = write && project.manifest.set(&packages, out)?;

    opened_copy::place(&outdated, out)?;
    tell(copies, out);
    if changed {
        project.manifest.write()?;
        eprintln!("the manifest takes it from there");
    } else if !write {
        print!("{lines}");
    }
    for entry in elsewhere {
        let (package, old) = (entry.package, entry.folder.unwrap_or_default());
        let old = old.display();
        if write {
            eprintln!("{old} is left as it is, and not used any more");
        } else {
            eprintln!(
                "the manifest takes {package} from {old}: put the line in the place of that one"
            );
        }
    }
    Ok(())
}
