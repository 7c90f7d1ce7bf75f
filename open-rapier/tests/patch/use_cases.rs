//! The ways in which a user runs the program, in different orders.

use std::fs;

use crate::fixture::{BOTH, Fixture};
use crate::seam::FILES;

const LINES: &str = "[patch.crates-io]\nrapier2d = { path = \"copies/rapier2d\" }\nrapier3d = { path = \"copies/rapier3d\" }\n";

#[test]
fn makes_copies_and_prints_the_lines() {
    let fixture = Fixture::new(BOTH);
    let manifest = fixture.manifest();
    assert_eq!(fixture.run(&[]).succeeds(), LINES);
    fixture.check_manifest(&manifest);
    for package in ["rapier2d", "rapier3d"] {
        let copy = format!("project/copies/{package}");
        for (name, contents, _) in FILES {
            assert_eq!(fixture.read(&format!("{copy}/{name}")), *contents);
        }
        for name in [".cargo-ok", ".cargo-checksum.json", "Cargo.lock"] {
            assert!(!fixture.path(&format!("{copy}/{name}")).exists());
        }
        let manifest = fixture.read(&format!("{copy}/Cargo.toml"));
        assert!(manifest.contains(&format!("links = \"opened-{package}\"")));
        let changed = fixture.read(&format!("{copy}/src/pipeline/query_pipeline.rs"));
        assert!(changed.starts_with("// Modified by open-rapier"));
        assert_eq!(changed.matches("bvh: self.bvh(),").count(), 2);
        let note = fixture.read(&format!("{copy}/PATCHED.md"));
        assert!(
            note.contains("`src/pipeline/query_pipeline.rs` | modified") && note.contains("Apache"),
            "{note}"
        );
    }
}

#[test]
fn copies_only_the_packages_of_the_project() {
    let fixture = Fixture::new(&[("rapier3d-f64", "0.36.1"), ("rapier2d", "0.27.0")]);
    let lines = "[patch.crates-io]\nrapier3d-f64 = { path = \"copies/rapier3d-f64\" }\n";
    assert_eq!(fixture.run(&[]).succeeds(), lines);
}

#[test]
fn keeps_the_format_of_the_manifest() {
    let fixture = Fixture::new(BOTH);
    fixture.package("other", "other", "0.1.0");
    let odd = "# My game.\n[package]\nname   = 'game' # odd\nedition=\"2024\"\n\n\n[dependencies]\nrapier2d=\"0.36\"\n  rapier3d = { version = \"0.36.1\" }\n";
    let patched = format!("{odd}\n[patch.crates-io] # mine\nother = {{ path = \"../other\" }}\n");
    let entries = LINES.split_once('\n').unwrap().1;
    for (manifest, added) in [(odd, &*format!("\n{LINES}")), (&patched, entries)] {
        for end in ["\n", "\r\n"] {
            for mark in ["", "\u{feff}"] {
                let as_written = |text: &str| format!("{mark}{}", text.replace('\n', end));
                fixture.write_manifest(&as_written(manifest));
                assert_eq!(fixture.run(&["--write"]).succeeds(), "");
                fixture.check_manifest(&as_written(&format!("{manifest}{added}")));
                fixture.check_folder("rapier3d", "project/copies/rapier3d");
                fixture.run(&["--undo"]).succeeds();
                fixture.check_manifest(&as_written(manifest));
            }
        }
    }
}

#[test]
fn replaces_only_what_differs() {
    let fixture = Fixture::new(BOTH);
    let outcome = fixture.run(&["--check"]);
    outcome.fails(&["copies/rapier2d is missing"]);
    assert!(!fixture.path("project/copies").exists());
    fixture.run(&["--write"]).succeeds();
    // Cargo writes the lock file of the patched project.
    fixture.folders_of("rapier3d");
    let state = fixture.state("project");
    fixture.run(&["--check"]).succeeds();
    fixture.run(&["--write"]).succeeds();
    assert_eq!(fixture.run(&[]).succeeds(), LINES);
    assert!(fixture.state("project") == state);

    // Copies that the user has edited, and then a copy that is gone.
    let contents = |fixture: &Fixture| {
        let state = fixture.state("project").into_iter();
        let contents = state.map(|(name, (text, _))| (name, text));
        contents.collect::<Vec<_>>()
    };
    let good = contents(&fixture);
    let edited = "copies/rapier3d/src/pipeline/query_pipeline.rs";
    let missing = "copies/rapier2d/src/pipeline/physics_world.rs";
    fixture.write(&format!("project/{edited}"), "// Mine.\n");
    fixture.write("project/copies/rapier3d/src/mine.rs", "");
    fs::remove_file(fixture.path(&format!("project/{missing}"))).unwrap();
    fixture.run(&["--check"]).fails(&[
        &format!("{edited} is different"),
        &format!("{missing} is missing"),
        "copies/rapier3d/src/mine.rs is not part of the copy",
    ]);
    fixture.run(&[]).succeeds();
    assert!(contents(&fixture) == good);
    fs::remove_dir_all(fixture.path("project/copies/rapier3d")).unwrap();
    fixture.run(&["--write"]).succeeds();
    assert!(contents(&fixture) == good);

    // A copy of the first version of the program, whose note had another name.
    let note = "project/copies/rapier3d/PATCHED.md";
    let text = fixture.read(note).replace("# Patched", "# Opened");
    fs::remove_file(fixture.path(note)).unwrap();
    fixture.write("project/copies/rapier3d/OPENED.md", &text);
    fixture.run(&[]).succeeds();
    assert!(contents(&fixture) == good);

    let outcome = fixture.run(&["--check", "--write"]);
    outcome.fails(&["cannot be used with"]);
}

#[test]
fn uses_an_entry_with_another_name() {
    let fixture = Fixture::new(BOTH);
    let manifest = fixture.manifest();
    let patch =
        "[patch.crates-io]\nflat = { package = \"rapier2d\", path = \"./copies/rapier2d\" }\n";
    fixture.write_manifest(&format!("{manifest}\n{patch}"));
    fixture.run(&["--write"]).succeeds();
    fixture.check_folder("rapier2d", "project/copies/rapier2d");
    fixture.check_folder("rapier3d", "project/copies/rapier3d");
    fixture.run(&["--check"]).succeeds();
}

#[test]
fn patches_the_root_of_a_workspace() {
    let fixture = Fixture::new(BOTH);
    let member = fixture.manifest();
    fixture.write("project/games/first/Cargo.toml", &member);
    fixture.write("project/games/first/src/lib.rs", "");
    let root = "[workspace]\nresolver = \"3\"\nmembers = [\"games/*\"]\n";
    fixture.write_manifest(root);
    let options = ["--out=../../engines", "--write"];
    fixture.run_in("project/games/first", &options).succeeds();
    assert_eq!(fixture.read("project/games/first/Cargo.toml"), member);
    let line = "rapier3d = { path = \"engines/rapier3d\" }";
    assert!(fixture.manifest().contains(line));
    // Relative paths start at the folder in which the program runs.
    fs::create_dir(fixture.path("elsewhere")).unwrap();
    let manifest = "--manifest-path=../project/games/first/Cargo.toml";
    let options = ["--out=../project/engines", manifest, "--check"];
    fixture.run_in("elsewhere", &options).succeeds();
    let options = ["--out=../project/engines", manifest, "--undo"];
    fixture.run_in("elsewhere", &options).succeeds();
    fixture.check_manifest(root);
    assert!(!fixture.path("project/engines").exists());
}

#[test]
fn allows_a_fork_of_another_version() {
    let fixture = Fixture::new(&[("rapier3d", "0.36.1")]);
    fixture.package("fork", "rapier3d", "0.27.3");
    let old = "old = { package = \"rapier3d\", version = \"0.27\" }\n";
    let patch = "\n[patch.crates-io]\nrapier3d = { path = \"../fork\" }\n";
    let manifest = fixture.manifest() + old + patch;
    fixture.write_manifest(&manifest);
    let line = "rapier3d-036 = { package = \"rapier3d\", path = \"copies/rapier3d\" }\n";
    let lines = format!("[patch.crates-io]\n{line}");
    assert_eq!(fixture.run(&[]).succeeds(), lines);
    fixture.run(&["--write"]).succeeds();
    fixture.check_manifest(&format!("{manifest}{line}"));
    let folders = fixture.folders_of("rapier3d");
    for expected in ["fork", "copies/rapier3d"] {
        assert!(folders.iter().any(|folder| folder.ends_with(expected)));
    }

    // Later runs find the entry and keep its key.
    let state = fixture.state("project");
    fixture.run(&["--write"]).succeeds();
    fixture.run(&["--check"]).succeeds();
    assert_eq!(fixture.run(&[]).succeeds(), lines);
    assert!(fixture.state("project") == state);
    let options = ["--out", "elsewhere", "--write"];
    fixture.run_in("project", &options).succeeds();
    fixture.check_manifest(&format!(
        "{manifest}{}",
        line.replace("copies", "elsewhere")
    ));
}

#[test]
fn moves_to_another_folder() {
    let fixture = Fixture::new(BOTH);
    fixture.run(&["--write"]).succeeds();
    let manifest = fixture.manifest();
    let copies = fixture.state("project/copies");

    let printed = fixture.run_in("project", &["--out", "elsewhere"]);
    assert!(printed.stderr.contains("the manifest uses rapier3d from"));
    assert_eq!(printed.succeeds(), LINES.replace("copies", "elsewhere"));
    fixture.check_manifest(&manifest);

    let written = fixture.run_in("project", &["--out", "elsewhere", "--write"]);
    assert!(written.stderr.contains("copies/rapier3d is no longer used"));
    written.succeeds();
    fixture.check_manifest(&manifest.replace("copies", "elsewhere"));
    fixture.check_folder("rapier3d", "project/elsewhere/rapier3d");
    assert!(fixture.state("project/copies") == copies);
    let options = ["--out", "elsewhere", "--check"];
    fixture.run_in("project", &options).succeeds();
    // And back.
    fixture.run(&["--write"]).succeeds();
    fixture.check_manifest(&manifest);
    // The entries lead to the other folder.
    let undone = fixture.run_in("project", &["--out", "elsewhere", "--undo"]);
    assert!(undone.stderr.contains("still uses rapier3d from"));
    undone.succeeds();
    fixture.check_manifest(&manifest);
    assert!(!fixture.path("project/elsewhere").exists());
    fixture.check_folder("rapier3d", "project/copies/rapier3d");
}

#[test]
fn undo_leaves_nothing() {
    let fixture = Fixture::new(BOTH);
    let manifest = fixture.manifest();
    for missing in ["nothing", "copies/rapier2d", "copies"] {
        fixture.run(&["--write"]).succeeds();
        let _ = fs::remove_dir_all(fixture.path(&format!("project/{missing}")));
        let outcome = fixture.run(&["--undo"]);
        for removed in ["rapier2d below", "rapier3d below", "[patch.crates-io] from"] {
            let removed = format!("removed {removed}");
            assert!(outcome.stderr.contains(&removed), "{outcome:?}");
        }
        assert_eq!(outcome.succeeds(), "");
        fixture.check_manifest(&manifest);
        assert!(!fixture.path("project/copies").exists());
        assert_eq!(fixture.folders_of("rapier3d").len(), 1);
        fixture.check_folder("rapier3d", "registry/rapier3d-0.36.1");
    }
    let state = fixture.state("project");
    let outcome = fixture.run(&["--undo"]);
    assert!(outcome.stderr.contains("nothing to undo"), "{outcome:?}");
    outcome.succeeds();
    assert!(fixture.state("project") == state);
    let outcome = fixture.run(&["--undo", "--write"]);
    outcome.fails(&["cannot be used with"]);
}

#[test]
fn undo_keeps_other_patches() {
    let fixture = Fixture::new(BOTH);
    fixture.package("other", "other", "0.1.0");
    let manifest = fixture.manifest();
    let other = "other = { path = \"../other\" }";
    for patch in [
        &*format!("# A.\n[patch.crates-io] # B.\n# C.\n{other} # D.\n# E.\n"),
        &format!("[patch]\ncrates-io = {{ {other} }} # mine\n\n# The end.\n"),
        "[patch]\ncrates-io.other.path = \"../other\"\n",
        "[patch.crates-io.other]\npath = \"../other\"\n\n[profile.dev]\n",
    ] {
        let manifest = format!("{manifest}\n{patch}");
        fixture.write_manifest(&manifest);
        fixture.run(&["--write"]).succeeds();
        fixture.check_folder("rapier3d", "project/copies/rapier3d");
        fixture.run(&["--undo"]).succeeds();
        fixture.check_manifest(&manifest);
    }

    // Lines that the user has rewritten, among comments.
    let comments = format!("{manifest}\n# A.\n# B.\n\n# C.\n");
    let lines = "[patch.crates-io]\n# B.\nrapier2d.path = \"copies/rapier2d\"\n";
    let table = "\n[patch.crates-io.rapier3d] # mine\npath = \"copies/rapier3d\"\n# C.\n";
    fixture.write_manifest(&format!("{manifest}\n# A.\n{lines}{table}"));
    fixture.run(&["--undo"]).succeeds();
    fixture.check_manifest(&comments);
}

#[test]
fn undo_keeps_folders_of_the_user() {
    let fixture = Fixture::new(BOTH);
    let manifest = fixture.manifest();
    fixture.run(&["--write"]).succeeds();
    fixture.write("project/copies/precious.txt", "mine");
    fs::remove_dir_all(fixture.path("project/copies/rapier3d")).unwrap();
    fixture.package("project/copies/rapier3d", "rapier3d", "0.36.4");
    let kept = fixture.run(&["--undo"]);
    assert!(kept.stderr.contains("still uses rapier3d from"), "{kept:?}");
    kept.succeeds();
    let line = "rapier3d = { path = \"copies/rapier3d\" }";
    fixture.check_manifest(&format!("{manifest}\n[patch.crates-io]\n{line}\n"));
    assert!(!fixture.path("project/copies/rapier2d").exists());
    assert_eq!(fixture.read("project/copies/precious.txt"), "mine");
    assert!(fixture.path("project/copies/rapier3d/src/lib.rs").exists());
}

#[cfg(unix)]
#[test]
fn follows_a_link_to_the_manifest() {
    let fixture = Fixture::new(BOTH);
    let manifest = fixture.manifest();
    fs::create_dir(fixture.path("project/manifests")).unwrap();
    let (link, target) = ("project/Cargo.toml", "project/manifests/game.toml");
    fs::rename(fixture.path(link), fixture.path(target)).unwrap();
    std::os::unix::fs::symlink("manifests/game.toml", fixture.path(link)).unwrap();
    for _ in 0..2 {
        fixture.run(&["--write"]).succeeds();
        assert!(fixture.path(link).is_symlink());
        assert_eq!(fixture.read(target), format!("{manifest}\n{LINES}"));
        fixture.check_folder("rapier3d", "project/copies/rapier3d");
    }
    fixture.run(&["--check"]).succeeds();
}
