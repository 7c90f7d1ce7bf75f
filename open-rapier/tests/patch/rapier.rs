//! Rapier itself: its texts are as the edits expect, and the copies compile.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::fixture::outcome;
use crate::seam::PACKAGES;

/// `benches/patched` has programs that implement the trait.
const LIBRARY: &str = "pub use rapier2d::prelude::CustomBroadPhase;";

const MANIFEST: &str = "
[workspace]
[package]
name = \"game\"
edition = \"2024\"
[dependencies]
rapier2d = { version = \"0.36.1\", features = [\"parallel\", \"serde-serialize\"] }
rapier3d = { version = \"0.36.1\", features = [\"parallel\", \"serde-serialize\"] }
rapier2d-f64 = { version = \"0.36.1\", optional = true }
rapier3d-f64 = { version = \"0.36.1\", optional = true }
";

/// The folder is kept between runs, so that Rapier's dependencies are compiled once.
#[test]
#[ignore = "compiles two engines; `.ci/full support` runs it"]
fn copies_of_rapier_compile() {
    let site = Path::new(env!("CARGO_TARGET_TMPDIR")).join("open-rapier");
    fs::create_dir_all(site.join("src")).unwrap();
    fs::write(site.join("Cargo.toml"), MANIFEST).unwrap();
    fs::write(site.join("src/lib.rs"), LIBRARY).unwrap();
    for option in ["--write", "--check"] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_open-rapier"));
        command.args(["--out", "copies", option]);
        outcome(command.current_dir(&site)).succeeds();
    }
    for package in PACKAGES {
        let note = Path::new("copies").join(package).join("PATCHED.md");
        assert!(site.join(note).exists());
    }
    let mut command = Command::new(env!("CARGO"));
    command
        .args(["check", "--quiet"])
        .env("CARGO_TARGET_DIR", site.join("target"));
    outcome(command.current_dir(&site)).succeeds();
}
