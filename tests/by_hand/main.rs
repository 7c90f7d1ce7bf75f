//! Single updates with handwritten lists, in every version of Rapier; and updates with the published Rapier 0.36, whose pipelines accept no
//! custom broad phase.
#![cfg(feature = "_adapter")]

#[path = "../common/flavours.rs"]
#[macro_use]
mod flavours;

#[allow(unused_macros)]
macro_rules! flavour {
    ($name:ident, $rapier:ident, $unisize:ident, $dim:tt, $version:tt $(, $published:ident)?) => {
        #[path = "."]
        mod $name {
            use desk::Desk;
            use rapier::prelude::*;
            use unisize::$unisize::{PairFilter, Settings, UnisizeBroadPhase};
            use $rapier as rapier;

            mod choices;
            #[path = "../common/desk.rs"]
            mod desk;
            mod hostile;
            $(mod $published;)?
        }
    };
}

#[allow(unused_macros)]
macro_rules! published {
    ($($flavour:tt)*) => {
        flavour!($($flavour)*, published);
    };
}

for_each_027!(flavour);
for_each_036!(published);

// rustfmt does not look into macros.
#[cfg(rustfmt)]
mod choices;
#[cfg(rustfmt)]
mod hostile;
#[cfg(rustfmt)]
mod published;
