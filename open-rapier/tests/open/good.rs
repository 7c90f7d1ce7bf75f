//! What a user does, in all orders.

use std::fs;

use crate::fixture::{BOTH, Fixture};
use crate::seam::{FACTORY_FILES, FILES};

const LINES: &str = "[patch.crates-io]\nrapier2d = { path = \"copies/rapier2d\" }\nrapier3d = { path = \"copies/rapier3d\" }\n";

#[test]
fn copies_and_prints_the_lines() {
    let fixture = Fixture::new(BOTH);
    let manifest = fixture.read("project/Cargo.toml");
    assert_eq!(fixture.run(&[]).good(), LINES);
    assert_eq!(fixture.read("project/Cargo.toml"), manifest);
    for package in ["rapier2d", "rapier3d"] {
        let copy = format!("project/copies/{package}");
        for (name, contents, _) in FILES {
            assert_eq!(fixture.read(&format!("{copy}/{name}")), *contents);
        }
        for (name, ..) in FACTORY_FILES {
            assert!(!fixture.path(&format!("{copy}/{name}")).exists());
        }
        for name in [".cargo-ok", ".cargo-checksum.json", "Cargo.lock"] {
            assert!(!fixture.path(&format!("{copy}/{name}")).exists());
        }
        assert!(
            fixture
                .read(&format!("{copy}/Cargo.toml"))
                .contains(&format!("links = \"opened-{package}\""))
        );
        let changed = fixture.read(&format!("{copy}/src/pipeline/query_pipeline.rs"));
        assert!(changed.starts_with("// Modified by open-rapier"));
        assert_eq!(changed.matches("bvh: self.bvh(),").count(), 2);
        let note = fixture.read(&format!("{copy}/OPENED.md"));
        assert!(
            note.contains("`src/pipeline/query_pipeline.rs` | modified") && note.contains("Apache"),
            "{note}"
        );
        assert_eq!(
            fs::read_dir(fixture.path("project/copies"))
                .unwrap()
                .count(),
            2
        );
    }
}

#[test]
fn takes_what_the_project_uses() {
    let fixture = Fixture::new(&[("rapier3d-f64", "0.36.1"), ("rapier2d", "0.27.0")]);
    let lines = "[patch.crates-io]\nrapier3d-f64 = { path = \"copies/rapier3d-f64\" }\n";
    assert_eq!(fixture.run(&[]).good(), lines);
}

#[test]
fn writes_the_manifest_and_keeps_its_format() {
    let fixture = Fixture::new(BOTH);
    let odd = "# My game.\n[package]\nname   = 'game' # odd\nedition=\"2024\"\n\n\n[dependencies]\nrapier2d=\"0.36\"\n  rapier3d = { version = \"0.36.1\" }\n";
    fixture.write("project/Cargo.toml", odd);
    assert_eq!(fixture.run(&["--write"]).good(), "");
    assert_eq!(
        fixture.read("project/Cargo.toml"),
        format!("{odd}\n{LINES}")
    );
    assert!(
        fixture
            .folder_of("rapier3d")
            .ends_with("project/copies/rapier3d")
    );
}

#[test]
fn adds_to_a_patch() {
    let fixture = Fixture::new(BOTH);
    let manifest = fixture.read("project/Cargo.toml");
    fixture.write(
        "other/Cargo.toml",
        "[package]\nname = \"other\"\nedition = \"2024\"\n",
    );
    fixture.write("other/src/lib.rs", "");
    let patch = "\n[patch.crates-io] # mine\nother = { path = \"../other\" }\n";
    fixture.write("project/Cargo.toml", &format!("{manifest}{patch}"));
    fixture.run(&["--write"]).good();
    let lines = LINES.split_once('\n').unwrap().1;
    assert_eq!(
        fixture.read("project/Cargo.toml"),
        format!("{manifest}{patch}{lines}")
    );
}

#[test]
fn changes_nothing_the_second_time() {
    let fixture = Fixture::new(BOTH);
    fixture.run(&["--write"]).good();
    // Cargo writes the lock file of the patched project.
    fixture.folder_of("rapier3d");
    let state = fixture.state("project");
    fixture.run(&["--check"]).good();
    fixture.run(&["--write"]).good();
    assert_eq!(fixture.run(&[]).good(), LINES);
    assert!(fixture.state("project") == state);
}

#[test]
fn makes_copies_that_the_manifest_misses() {
    let fixture = Fixture::new(BOTH);
    fixture.run(&["--write"]).good();
    let manifest = fixture.read("project/Cargo.toml");
    fixture.remove("project/copies");
    fixture
        .run(&["--check"])
        .bad(&["copies/rapier2d is missing", "copies/rapier3d is missing"]);
    assert!(!fixture.path("project/copies").exists());
    fixture.run(&["--write"]).good();
    fixture.run(&["--check"]).good();
    fixture.remove("project/copies/rapier3d");
    fixture.run(&["--write"]).good();
    fixture.run(&["--check"]).good();
    assert_eq!(fixture.read("project/Cargo.toml"), manifest);
}

#[test]
fn follows_a_patch_by_another_name_or_in_the_configuration() {
    let fixture = Fixture::new(BOTH);
    let manifest = fixture.read("project/Cargo.toml");
    let patch =
        "[patch.crates-io]\nflat = { package = \"rapier2d\", path = \"./copies/rapier2d\" }\n";
    fixture.write("project/Cargo.toml", &format!("{manifest}\n{patch}"));
    fixture.run(&["--write"]).good();
    assert!(
        fixture
            .folder_of("rapier2d")
            .ends_with("project/copies/rapier2d")
    );
    assert!(
        fixture
            .folder_of("rapier3d")
            .ends_with("project/copies/rapier3d")
    );
    fixture.run(&["--check"]).good();
}

#[test]
fn patches_the_root_of_a_workspace() {
    let fixture = Fixture::new(BOTH);
    let member = fixture.read("project/Cargo.toml");
    fixture.write("project/games/first/Cargo.toml", &member);
    fixture.write("project/games/first/src/lib.rs", "");
    fixture.write(
        "project/Cargo.toml",
        "[workspace]\nresolver = \"3\"\nmembers = [\"games/*\"]\n",
    );
    fixture
        .run_in(
            "project/games/first",
            &["--out", "../../engines", "--write"],
        )
        .good();
    assert_eq!(fixture.read("project/games/first/Cargo.toml"), member);
    assert!(
        fixture
            .read("project/Cargo.toml")
            .contains("rapier3d = { path = \"engines/rapier3d\" }")
    );
    let path = "games/first/Cargo.toml";
    fixture
        .run_in(
            "project",
            &["--out", "engines", "--manifest-path", path, "--check"],
        )
        .good();
}
