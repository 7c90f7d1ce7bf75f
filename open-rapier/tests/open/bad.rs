//! What cannot be opened: an error that says why, and nothing is written.

use std::fs;

use crate::fixture::{BOTH, Fixture, Outcome};
use crate::seam::EDITS;

/// Runs with `--write`, and makes sure that neither copies nor the manifest were touched.
#[track_caller]
fn refused(fixture: &Fixture) -> Outcome {
    let manifest = fixture.manifest();
    let before = fixture.state("project/copies");
    let outcome = fixture.run(&["--write"]);
    fixture.check_manifest(&manifest);
    assert!(fixture.state("project/copies") == before);
    outcome
}

#[test]
fn other_versions() {
    for (dependencies, words) in [
        (
            &[("rapier2d", "0.36.1"), ("rapier3d", "0.36.0")][..],
            ["rapier3d 0.36.0", "--precise 0.36.1"],
        ),
        (
            &[("rapier2d", "0.27.0"), ("rapier3d", "0.37.0")],
            ["rapier2d 0.27.0, rapier3d 0.37.0", "only version 0.36.1"],
        ),
        (&[], ["uses none of them", "only version 0.36.1"]),
    ] {
        refused(&Fixture::new(dependencies)).bad(&words);
    }
}

/// Of two packages the second is not as expected, by every edit in turn.
#[test]
fn an_unexpected_text() {
    for edit in EDITS.iter().filter(|edit| edit.file != "Cargo.toml") {
        for times in [edit.times - 1, edit.times + 1] {
            let fixture = Fixture::new(BOTH);
            let file = format!("registry/rapier3d-0.36.1/{}", edit.file);
            let text = fixture.read(&file).replace(edit.find, "") + &edit.find.repeat(times);
            fixture.write(&file, &text);
            let first = edit.find.trim().lines().next().unwrap();
            let count = format!("found {times}");
            refused(&fixture).bad(&["rapier3d-0.36.1 cannot be opened", edit.file, &count, first]);
        }
    }
}

#[test]
fn a_missing_file_and_one_that_should_not_be_there() {
    let fixture = Fixture::new(BOTH);
    fs::remove_file(fixture.path("registry/rapier3d-0.36.1/src/pipeline/physics_world.rs"))
        .unwrap();
    refused(&fixture).bad(&["src/pipeline/physics_world.rs is missing"]);

    let fixture = Fixture::new(BOTH);
    fixture.write("registry/rapier3d-0.36.1/build.rs", "");
    refused(&fixture).bad(&["build.rs is there already"]);
}

#[test]
fn a_copy_stays_when_another_cannot_be_made() {
    let fixture = Fixture::new(BOTH);
    fixture.run(&[]).good();
    fixture.write("project/copies/rapier2d/src/lib.rs", "// Edited.\n");
    fixture.write("registry/rapier3d-0.36.1/src/geometry/mod.rs", "");
    refused(&fixture).bad(&["src/geometry/mod.rs"]);
}

#[test]
fn a_foreign_folder() {
    for precious in [
        "project/copies/rapier3d/precious.txt",
        "project/copies/rapier3d",
    ] {
        let fixture = Fixture::new(BOTH);
        fixture.write(precious, "mine");
        refused(&fixture).bad(&["copies/rapier3d was not made by open-rapier"]);
    }

    // An empty one is in nobody's way, nor is what else there is.
    let fixture = Fixture::new(BOTH);
    fixture.write("project/copies/precious.txt", "mine");
    fs::create_dir(fixture.path("project/copies/rapier3d")).unwrap();
    fixture.run(&[]).good();
    assert_eq!(fixture.read("project/copies/precious.txt"), "mine");
}

/// One that the project uses, of this patch release or of another.
#[test]
fn a_fork() {
    for version in ["0.36.1", "0.36.4"] {
        let fixture = Fixture::new(BOTH);
        fixture.package("fork", "rapier3d", version);
        let manifest = fixture.manifest().replace("=0.36.1", "0.36");
        let patch = "[patch.crates-io]\nrapier3d.path = \"../fork\"\n";
        fixture.write_manifest(&format!("{manifest}\n{patch}"));
        refused(&fixture).bad(&["rapier3d", version, "fork", "only that can be opened"]);
    }
}

/// A workspace without a package of its own, and its one member.
fn workspace(lines: &str) -> Fixture {
    let fixture = Fixture::new(BOTH);
    let member = fixture.manifest();
    fixture.write("project/crates/game/Cargo.toml", &member);
    fixture.write("project/crates/game/src/lib.rs", "");
    fixture.write_manifest(&format!("[workspace]\nresolver = \"3\"\n{lines}\n"));
    fixture
}

#[test]
fn copies_that_would_be_members() {
    let all = "members = [\"crates/*\"]";
    let hint = "\"crates/opened\" to `exclude`";
    for (lines, out, words) in [
        (all, "crates/opened", ["\"crates/*\" of `members`", hint]),
        (all, "crates", ["\"crates/*\"", "\"crates/rapier2d\" to"]),
        (
            "members = [\"./[a-z]*/game/../../crates/*/\"]",
            "crates/opened",
            ["\"./[a-z]*/game/../../crates/*/\"", hint],
        ),
        (
            "members = [\"crates/*\"]\nexclude = [\"crates/open\"]",
            "crates/opened/here",
            ["\"crates/*\"", hint],
        ),
        (
            "members = [\"crates/game\"]\ndefault-members = [\"crates/*\"]\nexclude = [\"crates\"]",
            "crates/opened",
            ["\"crates/*\" of `default-members`", "another --out;"],
        ),
    ] {
        let fixture = workspace(lines);
        let manifest = fixture.manifest();
        for options in [&["--out", out, "--write"][..], &["--out", out]] {
            fixture.run_in("project", options).bad(&words);
        }
        assert!(!fixture.path("project/crates/opened").exists());
        assert!(!fixture.path("project/crates/rapier2d").exists());
        fixture.check_manifest(&manifest);
    }
}

#[test]
fn copies_that_are_members() {
    let excluded = "members = [\"crates/*\"]\nexclude = [\"crates/opened\"]";
    let fixture = workspace(excluded);
    let options = ["--out", "crates/opened", "--write"];
    for _ in 0..2 {
        fixture.run_in("project", &options).good();
        fixture.check_folder("rapier3d", "crates/opened/rapier3d");
    }
    // By a list, without which nothing was made; and as the dependency of a member.
    let manifest = fixture.manifest();
    let lists = manifest.replace(excluded, "members = [\"crates/game\", \"crates/opened/*\"]");
    fixture.write_manifest(&lists);
    let words = ["\"crates/opened/*\" of `members`", "rapier2d"];
    fixture.run_in("project", &options).bad(&words);
    fixture.check_manifest(&lists);

    let fixture = Fixture::new(BOTH);
    fixture.run(&[]).good();
    let manifest = fixture.manifest();
    let manifest = manifest.replace("3d = \"=0.36.1\"", "3d.path = \"copies/rapier3d\"");
    fixture.write_manifest(&manifest);
    fixture.run(&["--check"]).good();
    fixture.write_manifest(&format!("{manifest}\n[workspace]\n"));
    refused(&fixture).bad(&["copies/rapier3d is a member of the workspace", "`exclude`"]);
}
