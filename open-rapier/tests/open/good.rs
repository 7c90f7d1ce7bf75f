//! What a user does, in all orders.

use std::fs;

use crate::fixture::{BOTH, Fixture};
use crate::seam::{FACTORY_FILES, FILES};

const LINES: &str = "[patch.crates-io]\nrapier2d = { path = \"copies/rapier2d\" }\nrapier3d = { path = \"copies/rapier3d\" }\n";

#[test]
fn copies_and_prints_the_lines() {
    let fixture = Fixture::new(BOTH);
    let manifest = fixture.manifest();
    assert_eq!(fixture.run(&[]).good(), LINES);
    fixture.check_manifest(&manifest);
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
    fixture.write_manifest(odd);
    assert_eq!(fixture.run(&["--write"]).good(), "");
    fixture.check_manifest(&format!("{odd}\n{LINES}"));
    fixture.check_folder("rapier3d", "project/copies/rapier3d");
}

#[test]
fn adds_to_a_patch() {
    let fixture = Fixture::new(BOTH);
    let manifest = fixture.manifest();
    fixture.package("other", "other", "0.1.0");
    let patch = "\n[patch.crates-io] # mine\nother = { path = \"../other\" }\n";
    fixture.write_manifest(&format!("{manifest}{patch}"));
    fixture.run(&["--write"]).good();
    let lines = LINES.split_once('\n').unwrap().1;
    fixture.check_manifest(&format!("{manifest}{patch}{lines}"));
}

#[test]
fn changes_nothing_the_second_time() {
    let fixture = Fixture::new(BOTH);
    fixture.run(&["--write"]).good();
    // Cargo writes the lock file of the patched project.
    fixture.folders_of("rapier3d");
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
    let manifest = fixture.manifest();
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
    fixture.check_manifest(&manifest);
}

#[test]
fn follows_a_patch_by_another_name_or_in_the_configuration() {
    let fixture = Fixture::new(BOTH);
    let manifest = fixture.manifest();
    let patch =
        "[patch.crates-io]\nflat = { package = \"rapier2d\", path = \"./copies/rapier2d\" }\n";
    fixture.write_manifest(&format!("{manifest}\n{patch}"));
    fixture.run(&["--write"]).good();
    fixture.check_folder("rapier2d", "project/copies/rapier2d");
    fixture.check_folder("rapier3d", "project/copies/rapier3d");
    fixture.run(&["--check"]).good();
}

#[test]
fn patches_the_root_of_a_workspace() {
    let fixture = Fixture::new(BOTH);
    let member = fixture.manifest();
    fixture.write("project/games/first/Cargo.toml", &member);
    fixture.write("project/games/first/src/lib.rs", "");
    fixture.write_manifest("[workspace]\nresolver = \"3\"\nmembers = [\"games/*\"]\n");
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
    // The manifest and the copies are looked for from where the program is run.
    fs::create_dir(fixture.path("elsewhere")).unwrap();
    let path = "../project/games/first/Cargo.toml";
    fixture
        .run_in(
            "elsewhere",
            &[
                "--out",
                "../project/engines",
                "--manifest-path",
                path,
                "--check",
            ],
        )
        .good();
}

#[test]
fn keeps_line_ends_and_a_byte_order_mark() {
    let fixture = Fixture::new(BOTH);
    let unix = fixture.manifest();
    let windows = unix.replace('\n', "\r\n");
    for (manifest, end) in [
        (format!("\u{feff}{unix}"), "\n"),
        (windows.clone(), "\r\n"),
        (format!("\u{feff}{windows}"), "\r\n"),
        (windows.trim_end().to_owned(), "\r\n"),
        (unix.replacen('\n', "\r\n", 2), "\n"),
    ] {
        fixture.write_manifest(&manifest);
        fixture.run(&["--write"]).good();
        let written = fixture.manifest();
        let added = written.strip_prefix(manifest.trim_end());
        assert_eq!(
            added.unwrap_or(&written),
            format!("\n\n{LINES}").replace('\n', end)
        );
        fixture.check_folder("rapier3d", "project/copies/rapier3d");
    }

    // In the midst of a patch; and two entries that are not neighbours, when they are moved.
    let entries = |out| {
        let rest = "other = { path = \"../other\" }\n\r\n[lib]\r\n# An end.\n";
        format!(
            "{windows}\r\n[patch.crates-io]\r\nrapier2d = {{ path = \"{out}/rapier2d\" }} # flat\r\n# solid:\nrapier3d.path='{out}/rapier3d'\n{rest}"
        )
    };
    fixture.package("other", "other", "0.1.0");
    fixture.write_manifest(&entries("copies"));
    let options = ["--out", "copy", "--write"];
    fixture.run_in("project", &options).good();
    fixture.check_manifest(&entries("copy").replace("'copy/rapier3d'", "\"copy/rapier3d\""));
}

#[test]
fn goes_beside_a_fork_of_another_version() {
    let fixture = Fixture::new(&[("rapier3d", "0.36.1")]);
    fixture.fork("0.27.3");
    let old = "old = { package = \"rapier3d\", version = \"0.27\" }\n";
    let patch = "\n[patch.crates-io]\nrapier3d = { path = \"../fork\" }\n";
    let manifest = fixture.manifest() + old + patch;
    fixture.write_manifest(&manifest);
    let line = "rapier3d-036 = { package = \"rapier3d\", path = \"copies/rapier3d\" }\n";
    let lines = format!("[patch.crates-io]\n{line}");
    assert_eq!(fixture.run(&[]).good(), lines);
    fixture.run(&["--write"]).good();
    fixture.check_manifest(&format!("{manifest}{line}"));
    let folders = fixture.folders_of("rapier3d");
    assert!(folders.iter().any(|folder| folder.ends_with("fork")));
    assert!(
        folders
            .iter()
            .any(|folder| folder.ends_with("copies/rapier3d"))
    );

    // It is known again, and moved by the same key.
    let state = fixture.state("project");
    fixture.run(&["--write"]).good();
    fixture.run(&["--check"]).good();
    assert_eq!(fixture.run(&[]).good(), lines);
    assert!(fixture.state("project") == state);
    let options = ["--out", "elsewhere", "--write"];
    fixture.run_in("project", &options).good();
    fixture.check_manifest(&format!(
        "{manifest}{}",
        line.replace("copies", "elsewhere")
    ));

    // That key may be taken too.
    let taken = manifest.replace(patch, &format!("{patch}rapier3d-036 = \"1\"\n"));
    fixture.write_manifest(&taken.replace("\"1\"", "{ package = \"other\", path = \"../other\" }"));
    fixture.package("other", "other", "0.1.0");
    let lines = fixture.run(&[]).good();
    assert!(lines.contains("\nrapier3d-036-036 = { package = \"rapier3d\""));
}

#[test]
fn moves_to_another_folder() {
    let fixture = Fixture::new(BOTH);
    fixture.run(&["--write"]).good();
    let manifest = fixture.manifest();
    let copies = fixture.state("project/copies");

    let printed = fixture.run_in("project", &["--out", "elsewhere"]);
    assert!(printed.stderr.contains("the manifest takes rapier3d from"));
    assert_eq!(printed.good(), LINES.replace("copies", "elsewhere"));
    fixture.check_manifest(&manifest);

    let written = fixture.run_in("project", &["--out", "elsewhere", "--write"]);
    assert!(written.stderr.contains("copies/rapier3d is left as it is"));
    written.good();
    fixture.check_manifest(&manifest.replace("copies", "elsewhere"));
    fixture.check_folder("rapier3d", "project/elsewhere/rapier3d");
    assert!(fixture.state("project/copies") == copies);
    fixture
        .run_in("project", &["--out", "elsewhere", "--check"])
        .good();
    // From the sources as published, so that nothing is opened twice.
    for package in ["rapier2d", "rapier3d"] {
        let file = format!("{package}/src/pipeline/query_pipeline.rs");
        assert_eq!(
            fixture.read(&format!("project/copies/{file}")),
            fixture.read(&format!("project/elsewhere/{file}"))
        );
    }
    // And back.
    fixture.run(&["--write"]).good();
    fixture.check_manifest(&manifest);
}

#[cfg(unix)]
#[test]
fn writes_what_a_linked_manifest_leads_to() {
    let fixture = Fixture::new(BOTH);
    let manifest = fixture.manifest();
    fs::create_dir(fixture.path("project/manifests")).unwrap();
    let (link, target) = ("project/Cargo.toml", "project/manifests/game.toml");
    fs::rename(fixture.path(link), fixture.path(target)).unwrap();
    std::os::unix::fs::symlink("manifests/game.toml", fixture.path(link)).unwrap();
    for _ in 0..2 {
        fixture.run(&["--write"]).good();
        assert!(fixture.path(link).is_symlink());
        assert_eq!(fixture.read(target), format!("{manifest}\n{LINES}"));
        fixture.check_folder("rapier3d", "project/copies/rapier3d");
    }
    fixture.run(&["--check"]).good();
}
