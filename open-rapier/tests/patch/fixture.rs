//! A project in a temporary folder, with a folder of packages in place of crates.io.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::process::Command;
use std::time::SystemTime;

use tempfile::TempDir;
use walkdir::{DirEntry, WalkDir};

use crate::seam::EDITS;

/// The dependencies of a project: packages and versions.
pub(crate) const BOTH: &[(&str, &str)] = &[("rapier2d", "0.36.1"), ("rapier3d", "0.36.1")];

pub(crate) struct Fixture {
    site: TempDir,
}

/// The result of a run.
#[derive(Debug)]
pub(crate) struct Outcome {
    pub(crate) success: bool,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl Outcome {
    /// Returns the output of a run that must succeed.
    #[track_caller]
    pub(crate) fn succeeds(self) -> String {
        assert!(self.success, "{}", self.stderr);
        self.stdout
    }

    /// Checks that the run failed with an error that contains all of `words`.
    #[track_caller]
    pub(crate) fn fails(self, words: &[&str]) {
        assert!(!self.success, "{self:?}");
        for word in words {
            let stderr = &self.stderr;
            assert!(stderr.contains(word), "no {word:?} in: {stderr}");
        }
    }
}

impl Fixture {
    /// A project with these dependencies.
    pub(crate) fn new(dependencies: &[(&str, &str)]) -> Self {
        let fixture = Self {
            site: tempfile::tempdir().unwrap(),
        };
        let line = |(name, version): &_| format!("{name} = \"={version}\"\n");
        let lines: String = dependencies.iter().map(line).collect();
        fixture.write(
            "project/Cargo.toml",
            &format!("[package]\nname = \"game\"\nedition = \"2024\"\n\n[dependencies]\n{lines}"),
        );
        fixture.write("project/src/lib.rs", "");
        fixture.write(
            "project/.cargo/config.toml",
            "source.crates-io.replace-with = \"here\"\nsource.here.directory = \"../registry\"\n",
        );
        for (name, version) in dependencies {
            fixture.publish(name, version);
        }
        fixture
    }

    /// Adds a package with the texts of all edits to the registry.
    fn publish(&self, name: &str, version: &str) {
        let mut files = BTreeMap::from([
            ("src/lib.rs", String::new()),
            ("Cargo.toml", manifest(name, version) + "build = false\n"),
            (".cargo-checksum.json", "{\"files\":{}}".to_owned()),
            (".cargo-ok", "{\"v\":1}".to_owned()),
            ("Cargo.lock", "version = 4\n".to_owned()),
        ]);
        for edit in EDITS.iter().filter(|edit| edit.file != "Cargo.toml") {
            files
                .entry(edit.file)
                .or_default()
                .push_str(&edit.find.repeat(edit.times));
        }
        for (file, contents) in files {
            self.write(&format!("registry/{name}-{version}/{file}"), &contents);
        }
    }

    /// Adds another package, in a folder next to the project.
    pub(crate) fn package(&self, folder: &str, name: &str, version: &str) {
        self.write(&format!("{folder}/Cargo.toml"), &manifest(name, version));
        self.write(&format!("{folder}/src/lib.rs"), "");
    }

    pub(crate) fn manifest(&self) -> String {
        self.read("project/Cargo.toml")
    }

    pub(crate) fn write_manifest(&self, contents: &str) {
        self.write("project/Cargo.toml", contents);
    }

    #[track_caller]
    pub(crate) fn check_manifest(&self, expected: &str) {
        assert_eq!(self.manifest(), expected);
    }

    /// Checks the folder in which Cargo finds a package of the project.
    #[track_caller]
    pub(crate) fn check_folder(&self, package: &str, folder: &str) {
        let found = self.folders_of(package).remove(0);
        assert!(found.ends_with(folder), "{package} is from {found:?}");
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.site.path().join(name)
    }

    pub(crate) fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    pub(crate) fn write(&self, name: &str, contents: &str) {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, contents).unwrap();
    }

    /// Runs the program in the folder of the project, with the copies in `copies`.
    pub(crate) fn run(&self, options: &[&str]) -> Outcome {
        self.run_in("project", &[&["--out", "copies"], options].concat())
    }

    pub(crate) fn run_in(&self, folder: &str, options: &[&str]) -> Outcome {
        let mut command = Command::new(env!("CARGO_BIN_EXE_open-rapier"));
        command.args(options).env("CARGO_NET_OFFLINE", "true");
        outcome(command.current_dir(self.path(folder)))
    }

    /// The folders in which Cargo finds the versions of a package of the project.
    pub(crate) fn folders_of(&self, package: &str) -> Vec<PathBuf> {
        let metadata = cargo_metadata::MetadataCommand::new()
            .current_dir(self.path("project"))
            .env("CARGO_NET_OFFLINE", "true")
            .exec()
            .unwrap();
        let found = metadata.packages.iter();
        let found = found.filter(|found| found.name.as_str() == package);
        let folder = |found: &cargo_metadata::Package| found.manifest_path.parent().unwrap().into();
        found.map(folder).collect()
    }

    /// The contents and times of all files of a folder, if it exists.
    pub(crate) fn state(&self, folder: &str) -> BTreeMap<PathBuf, (Vec<u8>, SystemTime)> {
        let state = |entry: DirEntry| {
            let written = entry.metadata().unwrap().modified().unwrap();
            let text = fs::read(entry.path()).unwrap();
            (entry.into_path(), (text, written))
        };
        let entries = WalkDir::new(self.path(folder)).into_iter();
        let files = entries.filter_map(Result::ok);
        let files = files.filter(|entry| !entry.file_type().is_dir());
        files.map(state).collect()
    }
}

fn manifest(name: &str, version: &str) -> String {
    format!("[package]\nname = \"{name}\"\nversion = \"{version}\"\nedition = \"2024\"\n")
}

pub(crate) fn outcome(command: &mut Command) -> Outcome {
    let output = command.output().unwrap();
    Outcome {
        success: output.status.success(),
        stdout: String::from_utf8(output.stdout).unwrap(),
        stderr: String::from_utf8(output.stderr).unwrap(),
    }
}
