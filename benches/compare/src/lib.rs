//! Does unisize do the same as Rapier's own broad phase, and how much faster does it make a step?
//!
//! ```text
//! cargo run --release --manifest-path benches/Cargo.toml --package compare
//! ```
//!
//! simulates every scene in two and three dimensions with both broad phases side by side, compares the pairs
//! they hold and the contacts after every step, then times whole steps on each broad phase alone, and prints a table
//! for each dimension.
//! `benches/scenes/src/engine/comparison.rs` lists what is compared. Exits with 1 if anything differs, and
//! with 2 on a usage error.
//!
//! With the feature `rapier-036` it is of Rapier 0.36, on a patched copy: `benches/patched/compare` is that program.

mod case;
mod forecast;
mod options;
mod row;
mod run;
mod table;
#[cfg_attr(feature = "rapier-036", path = "version/rapier_036.rs")]
#[cfg_attr(not(feature = "rapier-036"), path = "version/rapier_027.rs")]
mod version;

pub use run::run;

/// What is compared in one dimension.
macro_rules! dimension {
    ($name:ident, $dim:literal) => {
        #[path = "."]
        mod $name {
            use super::version::$name::{ours, scenes};

            const DIM: u8 = $dim;

            mod dimension;
            pub(super) use dimension::compare;
        }
    };
}

dimension!(dim2, 2);
dimension!(dim3, 3);

// It does not look into macros.
#[cfg(rustfmt)]
mod dimension;
