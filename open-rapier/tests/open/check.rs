//! `--check` after something has happened to a copy.

use std::fs;

use crate::fixture::{BOTH, Fixture};

#[test]
fn names_what_was_edited() {
    let fixture = Fixture::new(BOTH);
    fixture.run(&["--write"]).good();
    let file = "project/copies/rapier3d/src/pipeline/query_pipeline.rs";
    let text = fixture.read(file);
    fixture.write(file, &format!("{text}\n"));
    fixture
        .run(&["--check"])
        .bad(&["copies/rapier3d/src/pipeline/query_pipeline.rs is different"]);
    fixture.run(&[]).good();
    assert_eq!(fixture.read(file), text);
    fixture.run(&["--check"]).good();
}

#[test]
fn names_what_is_missing_and_what_is_new() {
    let fixture = Fixture::new(BOTH);
    fixture.run(&["--write"]).good();
    fs::remove_file(fixture.path("project/copies/rapier2d/src/pipeline/physics_world.rs")).unwrap();
    fixture.write("project/copies/rapier3d/src/mine.rs", "");
    fixture.run(&["--check"]).bad(&[
        "copies/rapier2d/src/pipeline/physics_world.rs is missing",
        "copies/rapier3d/src/mine.rs is not part of the copy",
    ]);
    fixture.run(&[]).good();
    fixture.run(&["--check"]).good();
}

#[test]
fn writes_nothing() {
    let fixture = Fixture::new(BOTH);
    fixture
        .run(&["--check"])
        .bad(&["copies/rapier2d is missing"]);
    assert!(!fixture.path("project/copies").exists());
    fixture
        .run(&["--check", "--write"])
        .bad(&["cannot be used with"]);
}

#[test]
fn tells_a_factory_from_none() {
    let fixture = Fixture::new(BOTH);
    fixture.run(&["--factory", "--write"]).good();
    fixture.run(&["--factory", "--check"]).good();
    fixture
        .run(&["--check"])
        .bad(&["copies/rapier3d/src/geometry/broad_phase_bvh/factory.rs is not part of the copy"]);
    let mended = fixture.read("project/copies/rapier3d/src/geometry/mod.rs");
    assert!(mended.contains("BROAD_PHASE_FACTORY"));
    fixture.run(&[]).good();
    fixture.run(&["--check"]).good();
}
