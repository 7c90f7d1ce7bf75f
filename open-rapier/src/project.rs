//! Which of Rapier's packages a project uses, and where Cargo has put their sources.
//!
//! Cargo is asked for both. A project whose patch leads to the copies hides the sources, or cannot be loaded at all while a
//! copy is missing. So the sources are then found with a manifest of ours, and put into the place of the copies while the project is asked.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};
use cargo_metadata::semver::Version;
use cargo_metadata::{CargoOpt, Metadata, MetadataCommand, Package};

use crate::patch::{Manifest, normal};
use crate::seam::{PACKAGES, VERSION};
use crate::{members, note};

/// A project that uses Rapier.
pub(crate) struct Project {
    /// The manifest of its workspace.
    pub(crate) manifest: Manifest,
    /// The packages to open, each with the folder of its sources.
    pub(crate) sources: BTreeMap<&'static str, PathBuf>,
}

impl Project {
    /// Asks Cargo about the project of a manifest whose copies are, or are to be, in `out`.
    pub(crate) fn find(manifest_path: &Path, out: &Path) -> Result<Self> {
        let manifest_path = &found_anywhere(manifest_path)?;
        let root = workspace_manifest(manifest_path)?;
        let manifest = Manifest::read(&root)?;
        // A copy that is a member already keeps Cargo from answering.
        let made = |package: &&str| note::is_ours(&out.join(package));
        members::ensure_none(&manifest, PACKAGES.into_iter().filter(made), out)?;
        let entries = manifest.entries(out);

        let asking = Asking {
            root: &root,
            manifest_path,
        };
        let mut sources = asking.fetched(entries.iter().map(|entry| entry.package))?;
        let options = entries.iter().flat_map(|entry| {
            let path = toml_edit::Value::from(&*sources[entry.package].to_string_lossy());
            let key = format!("patch.crates-io.{}", entry.key);
            let package = format!("{key}.package=\"{}\"", entry.package);
            [
                "--config".to_owned(),
                package,
                "--config".to_owned(),
                format!("{key}.path={path}"),
            ]
        });
        let metadata = asking.metadata(options.collect())?;

        let mut other_versions = vec![];
        let mut copies = vec![];
        for package in &metadata.packages {
            let Some(name) = PACKAGES
                .into_iter()
                .find(|name| *name == package.name.as_str())
            else {
                continue;
            };
            let folder = folder(package);
            let right = package.version.to_string() == VERSION;
            if right && is_published(package) {
                sources.insert(name, folder);
            } else if right && (folder == out.join(name) || note::is_copy(&folder, name)) {
                // Patched somewhere else than in the manifest.
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
                    "{name} {} is {}, not the one of crates.io: only that can be opened",
                    package.version,
                    package.id
                );
            }
        }
        sources.extend(asking.fetched(copies.into_iter())?);
        refuse_other_versions(&other_versions, sources.is_empty())?;
        members::ensure_none(&manifest, sources.keys().copied(), out)?;
        Ok(Self { manifest, sources })
    }
}

/// Whether it is the version that is opened, but for the last number.
fn is_close(version: &Version) -> bool {
    let opened = Version::parse(VERSION);
    opened.is_ok_and(|opened| (opened.major, opened.minor) == (version.major, version.minor))
}

/// Another patch release is a mistake; other versions may be there besides, if there is one to open.
fn refuse_other_versions(packages: &[&Package], nothing_found: bool) -> Result<()> {
    for package in packages {
        ensure!(
            !is_close(&package.version),
            "the project uses {name} {}; only {VERSION} can be opened: `cargo update --package {name}@{} --precise {VERSION}`",
            package.version,
            package.version,
            name = package.name
        );
    }
    if nothing_found {
        let list = packages
            .iter()
            .map(|package| format!("{} {}", package.name, package.version));
        let list = list.collect::<Vec<_>>().join(", ");
        let found = if list.is_empty() {
            "none of them".to_owned()
        } else {
            list
        };
        bail!(
            "nothing to open: the project uses {found}, and only version {VERSION} of {} can be opened",
            PACKAGES.join(", ")
        );
    }
    Ok(())
}

/// The path of a manifest from any folder, for Cargo is run in another one. It must have its name, so a link of that name is kept.
fn found_anywhere(manifest_path: &Path) -> Result<PathBuf> {
    let path = std::path::absolute(manifest_path)?;
    Ok(match path.parent() {
        Some(folder) if path.ends_with("Cargo.toml") => normal(folder).join("Cargo.toml"),
        _ => normal(&path),
    })
}

/// The manifest of the workspace, which Cargo finds without a look at dependencies.
fn workspace_manifest(manifest_path: &Path) -> Result<PathBuf> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo)
        .args([
            "locate-project",
            "--workspace",
            "--message-format",
            "plain",
            "--manifest-path",
        ])
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

/// What questions to Cargo have in common.
struct Asking<'a> {
    root: &'a Path,
    manifest_path: &'a Path,
}

impl Asking<'_> {
    /// All packages of the project, with all features.
    fn metadata(&self, options: Vec<String>) -> Result<Metadata> {
        let mut command = MetadataCommand::new();
        command
            .manifest_path(self.manifest_path)
            .current_dir(self.folder());
        command
            .features(CargoOpt::AllFeatures)
            .other_options(options);
        Ok(command.exec()?)
    }

    /// The sources of packages, whatever the project makes of them.
    fn fetched(
        &self,
        packages: impl Iterator<Item = &'static str>,
    ) -> Result<BTreeMap<&'static str, PathBuf>> {
        let packages: Vec<_> = packages.collect();
        if packages.is_empty() {
            return Ok(BTreeMap::new());
        }
        let site = tempfile::tempdir()?;
        let dependencies: String = packages
            .iter()
            .map(|name| format!("{name} = \"={VERSION}\"\n"))
            .collect();
        let manifest = format!(
            "[workspace]\n[package]\nname = \"sources\"\nedition = \"2024\"\n[lib]\npath = \"lib.rs\"\n[dependencies]\n{dependencies}"
        );
        fs::write(site.path().join("Cargo.toml"), manifest)?;
        fs::write(site.path().join("lib.rs"), "")?;
        // So that Cargo need not fetch other versions of what Rapier depends on.
        let lock = self.folder().join("Cargo.lock");
        if lock.exists() {
            fs::copy(lock, site.path().join("Cargo.lock"))?;
        }
        let mut command = MetadataCommand::new();
        // The project's folder, for Cargo's configuration is found from there.
        command
            .manifest_path(site.path().join("Cargo.toml"))
            .current_dir(self.folder());
        let metadata = command.exec()?;
        let mut sources = BTreeMap::new();
        for name in packages {
            let mut found = metadata
                .packages
                .iter()
                .filter(|package| package.name.as_str() == name && is_published(package));
            let package = found
                .next()
                .with_context(|| format!("{name} {VERSION} is patched by Cargo's configuration"))?;
            sources.insert(name, folder(package));
        }
        Ok(sources)
    }

    fn folder(&self) -> &Path {
        self.root.parent().unwrap_or(Path::new("."))
    }
}

fn is_published(package: &Package) -> bool {
    package
        .source
        .as_ref()
        .is_some_and(|source| source.is_crates_io())
}

fn folder(package: &Package) -> PathBuf {
    normal(
        package
            .manifest_path
            .as_std_path()
            .parent()
            .unwrap_or(Path::new("")),
    )
}
