//! Projects that cannot be patched: the program fails with a reason and writes nothing.

use std::fs;

use crate::fixture::{BOTH, Fixture, Outcome};
use crate::seam::EDITS;

/// Runs with `--write`, and checks that neither the copies nor the manifest have changed.
#[track_caller]
fn run_unchanged(fixture: &Fixture) -> Outcome {
    let manifest = fixture.manifest();
    let before = fixture.state("project/copies");
    let outcome = fixture.run(&["--write"]);
    fixture.check_manifest(&manifest);
    assert!(fixture.state("project/copies") == before);
    outcome
}

#[test]
fn other_versions_are_refused() {
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
        run_unchanged(&Fixture::new(dependencies)).fails(&words);
    }
}

/// For each edit in turn, the second of two packages has its text once too often or too seldom.
#[test]
fn unexpected_text_is_refused() {
    for edit in EDITS.iter().filter(|edit| edit.file != "Cargo.toml") {
        for times in [edit.times - 1, edit.times + 1] {
            let fixture = Fixture::new(BOTH);
            let file = format!("registry/rapier3d-0.36.1/{}", edit.file);
            let text = fixture.read(&file).replace(edit.find, "") + &edit.find.repeat(times);
            fixture.write(&file, &text);
            let first = edit.find.trim().lines().next().unwrap();
            let count = format!("found {times}");
            run_unchanged(&fixture).fails(&[
                "rapier3d-0.36.1 cannot be patched",
                edit.file,
                &count,
                first,
            ]);
        }
    }
}

#[test]
fn missing_and_unexpected_files_are_refused() {
    let fixture = Fixture::new(BOTH);
    fs::remove_file(fixture.path("registry/rapier3d-0.36.1/src/pipeline/physics_world.rs"))
        .unwrap();
    run_unchanged(&fixture).fails(&["src/pipeline/physics_world.rs is missing"]);

    let fixture = Fixture::new(BOTH);
    fixture.write("registry/rapier3d-0.36.1/build.rs", "");
    run_unchanged(&fixture).fails(&["build.rs exists already"]);
}

#[test]
fn a_copy_stays_if_another_cannot_be_made() {
    let fixture = Fixture::new(BOTH);
    fixture.run(&[]).succeeds();
    fixture.write("project/copies/rapier2d/src/lib.rs", "// Edited.\n");
    fixture.write("registry/rapier3d-0.36.1/src/geometry/mod.rs", "");
    run_unchanged(&fixture).fails(&["src/geometry/mod.rs"]);
}

#[test]
fn folders_of_the_user_are_not_overwritten() {
    for precious in [
        "project/copies/rapier3d/precious.txt",
        "project/copies/rapier3d",
    ] {
        let fixture = Fixture::new(BOTH);
        fixture.write(precious, "mine");
        run_unchanged(&fixture).fails(&["copies/rapier3d was not made by open-rapier"]);
    }

    // Empty folders and other files in `--out` do not matter.
    let fixture = Fixture::new(BOTH);
    fixture.write("project/copies/precious.txt", "mine");
    fs::create_dir(fixture.path("project/copies/rapier3d")).unwrap();
    fixture.run(&[]).succeeds();
    assert_eq!(fixture.read("project/copies/precious.txt"), "mine");
}

/// A fork that the project uses, of this patch release or of another.
#[test]
fn forks_are_refused() {
    for version in ["0.36.1", "0.36.4"] {
        let fixture = Fixture::new(BOTH);
        fixture.package("fork", "rapier3d", version);
        let manifest = fixture.manifest().replace("=0.36.1", "0.36");
        let patch = "[patch.crates-io]\nrapier3d.path = \"../fork\"\n";
        fixture.write_manifest(&format!("{manifest}\n{patch}"));
        run_unchanged(&fixture).fails(&["rapier3d", version, "fork", "only that can be patched"]);
    }
}

/// A workspace with one member and no package of its own.
fn workspace(lines: &str) -> Fixture {
    let fixture = Fixture::new(BOTH);
    let member = fixture.manifest();
    fixture.write("project/crates/game/Cargo.toml", &member);
    fixture.write("project/crates/game/src/lib.rs", "");
    fixture.write_manifest(&format!("[workspace]\nresolver = \"3\"\n{lines}\n"));
    fixture
}

#[test]
fn copies_that_would_become_members_are_refused() {
    let all = "members = [\"crates/*\"]";
    let hint = "\"crates/patched\" to `exclude`";
    for (lines, out, words) in [
        (all, "crates/patched", ["\"crates/*\" of `members`", hint]),
        (all, "crates", ["\"crates/*\"", "\"crates/rapier2d\" to"]),
        (
            "members = [\"./[a-z]*/game/../../crates/*/\"]",
            "crates/patched",
            ["\"./[a-z]*/game/../../crates/*/\"", hint],
        ),
        (
            "members = [\"crates/*\"]\nexclude = [\"crates/patch\"]",
            "crates/patched/here",
            ["\"crates/*\"", hint],
        ),
        (
            "members = [\"crates/game\"]\ndefault-members = [\"crates/*\"]\nexclude = [\"crates\"]",
            "crates/patched",
            ["\"crates/*\" of `default-members`", "another --out;"],
        ),
    ] {
        let fixture = workspace(lines);
        let manifest = fixture.manifest();
        for options in [&["--out", out, "--write"][..], &["--out", out]] {
            fixture.run_in("project", options).fails(&words);
        }
        assert!(!fixture.path("project/crates/patched").exists());
        assert!(!fixture.path("project/crates/rapier2d").exists());
        fixture.check_manifest(&manifest);
    }
}

#[test]
fn copies_that_are_members_are_refused() {
    let excluded = "members = [\"crates/*\"]\nexclude = [\"crates/patched\"]";
    let fixture = workspace(excluded);
    let options = ["--out", "crates/patched", "--write"];
    for _ in 0..2 {
        fixture.run_in("project", &options).succeeds();
        fixture.check_folder("rapier3d", "crates/patched/rapier3d");
    }
    // The list of members changes after the copies were made.
    let manifest = fixture.manifest();
    let lists = manifest.replace(
        excluded,
        "members = [\"crates/game\", \"crates/patched/*\"]",
    );
    fixture.write_manifest(&lists);
    let words = ["\"crates/patched/*\" of `members`", "rapier2d"];
    fixture.run_in("project", &options).fails(&words);
    fixture.check_manifest(&lists);

    // A dependency by path makes a copy a member.
    let fixture = Fixture::new(BOTH);
    fixture.run(&[]).succeeds();
    let manifest = fixture.manifest();
    let manifest = manifest.replace("3d = \"=0.36.1\"", "3d.path = \"copies/rapier3d\"");
    fixture.write_manifest(&manifest);
    fixture.run(&["--check"]).succeeds();
    fixture.write_manifest(&format!("{manifest}\n[workspace]\n"));
    run_unchanged(&fixture).fails(&["copies/rapier3d is a member of the workspace", "`exclude`"]);
}
