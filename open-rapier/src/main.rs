//! Opens Rapier 0.36.1 for other broad phases than its own: copies the sources that Cargo has fetched, edits the copies, and has
//! the project take them.

mod edit;
mod line_ends;
mod members;
mod note;
mod opened_copy;
mod options;
mod patch;
mod placing;
mod project;
mod seam;

use std::path::{Path, PathBuf};

use anyhow::{Result, bail};
use clap::Parser;

use opened_copy::OpenedCopy;
use options::Options;
use project::Project;
use seam::VERSION;

fn main() -> Result<()> {
    let options = Options::parse();
    let out = patch::normal(&options.out);
    let project = Project::find(&options.manifest_path, &out)?;
    let opened = |(package, sources): (&&'static str, &PathBuf)| {
        OpenedCopy::new(package, sources, options.factory)
    };
    let copies = project
        .sources
        .iter()
        .map(opened)
        .collect::<Result<Vec<_>>>()?;
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
    if !differences.is_empty() {
        bail!(
            "not as open-rapier would make it:\n{}",
            differences.join("\n")
        );
    }
    for copy in copies {
        eprintln!(
            "{} {VERSION} is open in {}",
            copy.package,
            out.join(copy.package).display()
        );
    }
    Ok(())
}

/// Makes the copies that are not as they should be, after everything that may fail has been looked at.
fn open(mut project: Project, copies: &[OpenedCopy], out: &Path, write: bool) -> Result<()> {
    let packages: Vec<_> = copies.iter().map(|copy| copy.package).collect();
    let mut outdated = vec![];
    for copy in copies {
        let place = out.join(copy.package);
        placing::ensure_free(&place)?;
        // What is right is left alone, so that Cargo does not compile it again.
        if !copy.differences(&place)?.is_empty() {
            outdated.push(copy);
        }
    }
    let lines = project.manifest.lines(&packages, out);
    let mut elsewhere = project.manifest.entries(out);
    elsewhere.retain(|entry| packages.contains(&entry.package) && !entry.leads_to(out));
    let changed = write && project.manifest.set(&packages, out)?;

    placing::place(&outdated, out)?;
    for package in packages {
        eprintln!(
            "{package} {VERSION} is open in {}",
            out.join(package).display()
        );
    }
    if changed {
        project.manifest.write()?;
        eprintln!("the manifest takes it from there");
    } else if !write {
        print!("{lines}");
    }
    for entry in elsewhere {
        let old = entry.folder.unwrap_or_default();
        if write {
            eprintln!("{} is left as it is, and not used any more", old.display());
        } else {
            eprintln!(
                "the manifest takes {} from {}: put the line in the place of that one",
                entry.package,
                old.display()
            );
        }
    }
    Ok(())
}
