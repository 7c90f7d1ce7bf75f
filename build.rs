//! Finds out which copies of Rapier are open.
//!
//! A copy of Rapier 0.36 that `open-rapier` has opened tells those who depend on it, by cargo's metadata of build scripts,
//! which seam it has. For each such copy there is a `cfg`, under which `UnisizeBroadPhase` implements the trait of that
//! seam. Without an opened copy none is set, and everything else is the same.

use std::env;

/// The opened copies by name, in lower case with underscores.
const COPIES: [&str; 4] = ["rapier2d", "rapier3d", "rapier2d_f64", "rapier3d_f64"];

/// The seam that this version of the library knows.
const SEAM: &str = "1";

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    for copy in COPIES {
        println!("cargo::rustc-check-cfg=cfg(opened_{copy})");
        match env::var(format!("DEP_OPENED_{}_SEAM", copy.to_uppercase())) {
            Ok(seam) if seam == SEAM => println!("cargo::rustc-cfg=opened_{copy}"),
            Ok(seam) => println!(
                "cargo::warning=the opened copy of {copy} has seam {seam}, and this version of unisize knows seam {SEAM}: \
                 make the copy anew with the open-rapier of this version"
            ),
            Err(_) => {}
        }
    }
}
