//! Rapier itself: its texts are those that are expected, and copies compile.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::fixture::outcome;
use crate::seam::PACKAGES;

/// What a program sees of the seam.
const LIBRARY: &str = "
use rapier3d::prelude::*;

pub struct Forgetful(Bvh);

impl CustomBroadPhase for Forgetful {
    fn update(
        &mut self,
        _: &IntegrationParameters,
        _: &ColliderSet,
        _: &RigidBodySet,
        _: &[ColliderHandle],
        _: &[ColliderHandle],
        _: &mut Vec<BroadPhasePairEvent>,
    ) {
    }
    fn set_aabb(&mut self, _: &IntegrationParameters, _: ColliderHandle, _: Aabb) {}
    fn bvh(&self) -> &Bvh {
        &self.0
    }
    fn clone_box(&self) -> Box<dyn CustomBroadPhase> {
        Box::new(Self(self.0.clone()))
    }
}

pub fn world() -> PhysicsWorld {
    let mut world = PhysicsWorld::default();
    world.broad_phase = DefaultBroadPhase::custom(Forgetful(Bvh::new()));
    let _: Option<&Forgetful> = world.broad_phase.custom_ref();
    let _: Option<&mut Forgetful> = world.broad_phase.custom_mut();
    world
}

const _: () = assert!(env!(\"SEAMS\").len() == 2);
";

const BUILD: &str = "
fn main() {
    let seams = [\"DEP_OPENED_RAPIER2D_SEAM\", \"DEP_OPENED_RAPIER3D_SEAM\"].map(|name| std::env::var(name).unwrap());
    println!(\"cargo::rustc-env=SEAMS={}\", seams.concat());
}
";

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
fn copies_of_rapier_compile() {
    let site = Path::new(env!("CARGO_TARGET_TMPDIR")).join("open-rapier");
    fs::create_dir_all(site.join("src")).unwrap();
    for (name, contents) in [
        ("Cargo.toml", MANIFEST),
        ("build.rs", BUILD),
        ("src/lib.rs", LIBRARY),
    ] {
        fs::write(site.join(name), contents).unwrap();
    }
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
