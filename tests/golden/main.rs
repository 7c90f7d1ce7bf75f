//! The same boxes give the same events in the same order: in another run, on any number of threads, in a clone, after
//! a save, on every platform, in whatever way pairs are searched for and colliders listed, and in every version since a golden hash was taken.
//!
//! A changed hash means that the events, or their order, have changed. If that is intended, the test prints the new one for
//! `hashes.txt`.

#![cfg(any(
    feature = "rapier2d-027",
    feature = "rapier3d-027",
    feature = "rapier2d-f64-027",
    feature = "rapier3d-f64-027",
))]

mod hash;

#[path = "../flavours/mod.rs"]
#[macro_use]
mod flavours;

#[allow(unused_macros)]
macro_rules! flavour {
    ($name:ident, $rapier:ident, $unisize:ident, $dim:tt, $version:tt) => {
        #[path = "."]
        mod $name {
            #[cfg(feature = "enhanced-determinism")]
            use unisize::$unisize::PairFilter;
            use unisize::$unisize::{Kernel, Settings, Stats, UnisizeBroadPhase};
            use unisize_scenes::$name as scenes;
            use $rapier as rapier;

            const FLAVOUR: &str = stringify!($name);

            mod suite;
        }
    };
}

for_each_027!(flavour);

/// Checks the hash of a replay or a scene, which `hashes.txt` has for each flavour.
fn golden(flavour: &str, name: &str, found: &hash::Hash) {
    let mut rows = include_str!("hashes.txt").lines().skip(2);
    let mut columns = rows.next().expect("the names").split_whitespace();
    let column = columns.position(|column| column == flavour);
    let mut rows = rows.map(str::split_whitespace);
    let row = rows.find(|row| row.clone().next() == Some(name));
    let golden = row.and_then(|mut row| row.nth(column?));
    let found = format!("{:016x}", found.0);
    assert_eq!(golden, Some(&found[..]), "{name} in {flavour}");
}

// It does not look into macros.
#[cfg(rustfmt)]
mod suite;
