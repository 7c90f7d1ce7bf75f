//! Which of Rapier's packages a project uses, and where Cargo has put their sources.
//!
//! Cargo is asked for both. A project whose patch leads to the copies hides the sources, or cannot be loaded at all while a
//! copy is missing. So the sources are then found with a manifest of ours, and put into the place of the copies while the project is asked.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};
use cargo_metadata::{CargoOpt, Metadata, MetadataCommand, Package};

use crate::patch::{Manifest, normal};
use crate::seam::{PACKAGES, VERSION};

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
        let root = workspace_manifest(manifest_path)?;
        let manifest = Manifest::read(&root)?;
        let mut entries = manifest.entries();
        entries.retain(|entry| {
            entry
                .folder
                .as_deref()
                .is_some_and(|folder| normal(folder) == out.join(entry.package))
        });

        let asking = Asking {
            root: &root,
            manifest_path,
        };
        let mut sources = asking.fetched(entries.iter().map(|entry| entry.package))?;
        let options = entries.iter().flat_map(|entry| {
            let path =
                toml_edit::Value::from(sources[entry.package].to_string_lossy().into_owned());
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
            if package.version.to_string() != VERSION {
                other_versions.push(package);
            } else if is_published(package) {
                sources.insert(name, folder(package));
            } else if folder(package) == out.join(name) {
                // Patched somewhere else than in the manifest.
                copies.push(name);
            } else {
                ensure!(
                    sources.get(name) == Some(&folder(package)),
                    "{name} is {}, not the one of crates.io: only that can be opened",
                    package.id
                );
            }
        }
        sources.extend(asking.fetched(copies.into_iter())?);
        refuse_other_versions(&other_versions, sources.is_empty())?;
        Ok(Self { manifest, sources })
    }
}

/// Another patch release is a mistake; other versions may be there besides, if there is one to open.
fn refuse_other_versions(packages: &[&Package], nothing_found: bool) -> Result<()> {
    let opened: cargo_metadata::semver::Version = VERSION.parse()?;
    let close = |package: &&&Package| {
        (package.version.major, package.version.minor) == (opened.major, opened.minor)
    };
    if let Some(package) = packages.iter().find(close) {
        bail!(
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
