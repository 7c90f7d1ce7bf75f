//! The packages of Rapier that a project uses, and the folders in which Cargo has put their sources.
//!
//! `cargo metadata` knows both, except in a project that uses copies already: there the copies hide the sources, and a missing copy is an
//! error. So the sources of those packages are looked up through a temporary project, and replace the copies in the call for the project.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};
use cargo_metadata::semver::Version;
use cargo_metadata::{CargoOpt, MetadataCommand, Package};

use crate::manifest::{Manifest, normal};
use crate::seam::{PACKAGES, VERSION};
use crate::{members, note};

/// A project that uses Rapier.
pub(crate) struct Project {
    /// The manifest of its workspace.
    pub(crate) manifest: Manifest,
    /// The packages to patch, each with the folder of its sources.
    pub(crate) sources: BTreeMap<&'static str, PathBuf>,
}

impl Project {
    /// Finds the project of a manifest, whose copies are in `out` or will be.
    pub(crate) fn find(manifest_path: &Path, out: &Path) -> Result<Self> {
        let manifest_path = &found_anywhere(manifest_path)?;
        let manifest = manifest(manifest_path)?;
        // If a copy is a member already, Cargo may fail with a message that does not help.
        let made = |package: &&str| note::is_ours(&out.join(package));
        members::ensure_none(&manifest, PACKAGES.into_iter().filter(made), out)?;
        let entries = manifest.entries(out);

        let mut sources = fetched(entries.iter().map(|entry| entry.package), &manifest)?;
        let options = entries.iter().flat_map(|entry| {
            let path = toml_edit::Value::from(&*sources[entry.package].to_string_lossy());
            let key = format!("patch.crates-io.{}", entry.key);
            let package = format!("{key}.package=\"{}\"", entry.package);
            let path = format!("{key}.path={path}");
            ["--config".to_owned(), package, "--config".to_owned(), path]
        });
        // All packages of the project, with all features.
        let metadata = MetadataCommand::new()
            .manifest_path(manifest_path)
            .current_dir(manifest.folder())
            .features(CargoOpt::AllFeatures)
            .other_options(options.collect::<Vec<_>>())
            .exec()?;

        let mut other_versions = vec![];
        let mut copies = vec![];
        for package in &metadata.packages {
            let is_it = |name: &&str| *name == package.name.as_str();
            let Some(name) = PACKAGES.into_iter().find(is_it) else {
                continue;
            };
            let folder = folder(package);
            let right = package.version.to_string() == VERSION;
            if right && is_published(package) {
                sources.insert(name, folder);
            } else if right && (folder == out.join(name) || note::is_copy(&folder, name)) {
                // The patch is not in the manifest, but in Cargo's configuration or in a dependency by path.
                ensure!(
                    !metadata.workspace_members.contains(&package.id),
                    "{} is a member of the workspace, because a package depends on it by its path: have it depend on {name} {VERSION}, or add the folder to `exclude`; nothing was written",
                    folder.display()
                );
                copies.push(name);
            } else if is_published(package) || !is_close(&package.version) {
                other_versions.push(package);
            } else {
                ensure!(
                    sources.get(name) == Some(&folder),
                    "{name} {} is {}, not the one of crates.io: only that can be patched",
                    package.version,
                    package.id
                );
            }
        }
        sources.extend(fetched(copies.into_iter(), &manifest)?);
        refuse_other_versions(&other_versions, sources.is_empty())?;
        members::ensure_none(&manifest, sources.keys().copied(), out)?;
        Ok(Self { manifest, sources })
    }
}

/// The manifest of the workspace of a manifest.
pub(crate) fn manifest(manifest_path: &Path) -> Result<Manifest> {
    Manifest::read(&workspace_manifest(&found_anywhere(manifest_path)?)?)
}

/// Whether a version is a patch release of the one that can be patched.
fn is_close(version: &Version) -> bool {
    let ours = Version::parse(VERSION);
    ours.is_ok_and(|ours| (ours.major, ours.minor) == (version.major, version.minor))
}

/// Fails if there is another patch release, or if there are only other versions.
fn refuse_other_versions(packages: &[&Package], nothing_found: bool) -> Result<()> {
    for package in packages {
        ensure!(
            !is_close(&package.version),
            "the project uses {name} {}; only {VERSION} can be patched: `cargo update --package {name}@{} --precise {VERSION}`",
            package.version,
            package.version,
            name = package.name
        );
    }
    let name = |package: &&Package| format!("{} {}", package.name, package.version);
    let found: Vec<_> = packages.iter().map(name).collect();
    let found = match found.is_empty() {
        true => "none of them".to_owned(),
        false => found.join(", "),
    };
    ensure!(
        !nothing_found,
        "nothing to patch: the project uses {found}, and only version {VERSION} of {} can be patched",
        PACKAGES.join(", ")
    );
    Ok(())
}

/// The absolute path of a manifest, for Cargo runs in another folder. Cargo demands the name `Cargo.toml`, so a link of that name is kept.
fn found_anywhere(manifest_path: &Path) -> Result<PathBuf> {
    let path = std::path::absolute(manifest_path)?;
    Ok(match path.parent() {
        Some(folder) if path.ends_with("Cargo.toml") => normal(folder).join("Cargo.toml"),
        _ => normal(&path),
    })
}

/// The path of the manifest of the workspace. Cargo finds it without reading any dependencies.
fn workspace_manifest(manifest_path: &Path) -> Result<PathBuf> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo)
        .args(["locate-project", "--workspace", "--message-format=plain"])
        .arg("--manifest-path")
        .arg(manifest_path)
        .output()
        .context("cannot run cargo")?;
    ensure!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr).trim()
    );
    Ok(String::from_utf8(output.stdout)?.trim_end().into())
}

/// The folders of the sources of packages, whatever the project replaces them by.
fn fetched(
    packages: impl Iterator<Item = &'static str>,
    project: &Manifest,
) -> Result<BTreeMap<&'static str, PathBuf>> {
    let packages: Vec<_> = packages.collect();
    if packages.is_empty() {
        return Ok(BTreeMap::new());
    }
    let site = tempfile::tempdir()?;
    let dependency = |name: &&str| format!("{name} = \"={VERSION}\"\n");
    let dependencies: String = packages.iter().map(dependency).collect();
    let manifest = format!(
        "[workspace]\n[package]\nname = \"sources\"\nedition = \"2024\"\n[lib]\npath = \"lib.rs\"\n[dependencies]\n{dependencies}"
    );
    fs::write(site.path().join("Cargo.toml"), manifest)?;
    fs::write(site.path().join("lib.rs"), "")?;
    // So that Cargo need not fetch other versions of Rapier's dependencies.
    let lock = project.folder().join("Cargo.lock");
    if lock.exists() {
        fs::copy(lock, site.path().join("Cargo.lock"))?;
    }
    let metadata = MetadataCommand::new()
        .manifest_path(site.path().join("Cargo.toml"))
        // Cargo looks for its configuration from the project's folder.
        .current_dir(project.folder())
        .exec()?;
    let mut sources = BTreeMap::new();
    for name in packages {
        let is_it = |package: &&Package| package.name.as_str() == name && is_published(package);
        let package = metadata.packages.iter().find(is_it);
        let patched = || format!("{name} {VERSION} is patched by Cargo's configuration");
        sources.insert(name, folder(package.with_context(patched)?));
    }
    Ok(sources)
}

fn is_published(package: &Package) -> bool {
    let source = package.source.as_ref();
    source.is_some_and(|source| source.is_crates_io())
}

fn folder(package: &Package) -> PathBuf {
    let folder = package.manifest_path.parent();
    normal(folder.map_or(Path::new(""), |folder| folder.as_std_path()))
}
