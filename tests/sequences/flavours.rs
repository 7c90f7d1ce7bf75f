//! The suite in each flavour of Rapier whose feature is on, with what depends on its version. The fuzzer compiles this file as well.

#[path = "../flavours/mod.rs"]
#[macro_use]
mod list;

use crate::ops::Sequence;

#[allow(unused_macros)]
macro_rules! flavour {
    ($name:ident, $rapier:ident, $unisize:ident, $dim:tt, $version:tt) => {
        #[path = "."]
        mod $name {
            use unisize::$unisize::{Kernel, Settings, UnisizeBroadPhase};
            use $rapier as rapier;

            #[path = $dim]
            mod dim;
            pub(super) mod suite;
            #[path = $version]
            mod version;
        }
    };
}

for_each_027!(flavour);
for_each_036!(flavour);

/// Plays a sequence with lists made by hand and one of the kernels, in one of the eight flavours, if its feature is on.
pub(crate) fn play(sequence: &Sequence, flavour: usize, kernel: usize) {
    match flavour {
        #[cfg(feature = "rapier2d-027")]
        0 => dim2::suite::play(sequence, kernel),
        #[cfg(feature = "rapier3d-027")]
        1 => dim3::suite::play(sequence, kernel),
        #[cfg(feature = "rapier2d-f64-027")]
        2 => dim2_f64::suite::play(sequence, kernel),
        #[cfg(feature = "rapier3d-f64-027")]
        3 => dim3_f64::suite::play(sequence, kernel),
        #[cfg(feature = "rapier2d-036")]
        4 => dim2_036::suite::play(sequence, kernel),
        #[cfg(feature = "rapier3d-036")]
        5 => dim3_036::suite::play(sequence, kernel),
        #[cfg(feature = "rapier2d-f64-036")]
        6 => dim2_f64_036::suite::play(sequence, kernel),
        #[cfg(feature = "rapier3d-f64-036")]
        7 => dim3_f64_036::suite::play(sequence, kernel),
        _ => {}
    }
}
