//! Does unisize do the same as Rapier's own broad phase, and how much faster does it make a step?
//!
//! ```text
//! cargo run --release --manifest-path benches/Cargo.toml --package compare
//! ```
//!
//! simulates every scene in two and three dimensions with both broad phases side by side, compares the pairs
//! they hold and the contacts after every step, then times whole steps on each broad phase alone, and prints a table
//! for each dimension. `benches/scenes/src/engine/comparison.rs` lists the checks. The program exits with 1 if anything differs, and
//! with 2 on a usage error.
//!
//! The feature `rapier-036` builds it for a patched copy of Rapier 0.36; `benches/patched/compare` is that program.

mod case;
mod options;
mod row;
mod run;
mod table;

pub use run::run;

use unisize::PairFilter;

/// The version of Rapier.
const RAPIER: &str = if cfg!(feature = "rapier-036") {
    "0.36"
} else {
    "0.27"
};

/// The default of `--filter`, as the library has it.
const FILTER: &str = if cfg!(feature = "rapier-036") {
    "shapes"
} else {
    "off"
};

/// The level that leaves out the same pairs as the default broad phase.
const FILTER_OF_DEFAULT: PairFilter = match cfg!(feature = "rapier-036") {
    true => PairFilter::Groups,
    false => PairFilter::Off,
};

/// The comparison in one dimension.
macro_rules! dimension {
    ($name:ident, $dim:literal, $ours:ident, $scenes:ident) => {
        #[path = "."]
        mod $name {
            use unisize::$ours as ours;
            use unisize_scenes::$scenes as scenes;

            const DIM: u8 = $dim;

            mod dimension;
            pub(super) use dimension::compare;
        }
    };
}

#[cfg(not(feature = "rapier-036"))]
dimension!(dim2, 2, rapier2d_027, dim2);
#[cfg(not(feature = "rapier-036"))]
dimension!(dim3, 3, rapier3d_027, dim3);
#[cfg(feature = "rapier-036")]
dimension!(dim2, 2, rapier2d_036, dim2_036);
#[cfg(feature = "rapier-036")]
dimension!(dim3, 3, rapier3d_036, dim3_036);

// It does not look into macros.
#[cfg(rustfmt)]
mod dimension;
