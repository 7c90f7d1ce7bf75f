//! Finds out which engines are patched copies.
//!
//! A copy of Rapier 0.36 that `open-rapier` has patched names its seam to the packages that depend on it, in the metadata of Cargo's build
//! scripts. For each copy, this script sets a `cfg`, under which `UnisizeBroadPhase` implements the trait of that seam.

use std::env;

/// The names of the copies, in lower case with underscores.
const COPIES: [&str; 4] = ["rapier2d", "rapier3d", "rapier2d_f64", "rapier3d_f64"];

/// The seam that this version of the library knows.
const SEAM: &str = "4";

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    for copy in COPIES {
        println!("cargo::rustc-check-cfg=cfg(opened_{copy})");
        match env::var(format!("DEP_OPENED_{}_SEAM", copy.to_uppercase())) {
            Ok(seam) if seam == SEAM => println!("cargo::rustc-cfg=opened_{copy}"),
            Ok(seam) => println!(
                "cargo::warning=the patched copy of {copy} has seam {seam}, and this version of unisize knows seam {SEAM}: \
                 make the copy again with the open-rapier of this version"
            ),
            Err(_) => {}
        }
    }
}
