//! Single updates with lists made by hand, in every version of Rapier; and Rapier 0.36 as it is published, whose pipelines take no other
//! broad phase.
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

// It does not look into macros.
#[cfg(rustfmt)]
mod choices;
#[cfg(rustfmt)]
mod hostile;
#[cfg(rustfmt)]
mod published;
