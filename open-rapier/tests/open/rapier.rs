//! Rapier itself: its texts are those that are expected, and copies compile.

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

/// In a folder that is kept, so that the packages that Rapier depends on are compiled once.
#[test]
#[ignore = "compiles two engines more; `.ci/full support` runs it"]
fn copies_of_rapier_compile() {
    let site = Path::new(env!("CARGO_TARGET_TMPDIR")).join("open-rapier");
    fs::create_dir_all(site.join("src")).unwrap();
    fs::write(site.join("Cargo.toml"), MANIFEST).unwrap();
    fs::write(site.join("src/lib.rs"), LIBRARY).unwrap();
    let open = |options: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_open-rapier"));
        outcome(
            command
                .args(["--out", "copies"])
                .args(options)
                .current_dir(&site),
        )
        .good();
    };
    open(&["--write"]);
    open(&["--check"]);
    for package in PACKAGES {
        assert!(site.join("copies").join(package).join("OPENED.md").exists());
    }
    let mut command = Command::new(env!("CARGO"));
    command
        .args(["check", "--quiet"])
        .env("CARGO_TARGET_DIR", site.join("target"));
    outcome(command.current_dir(&site)).good();
}
