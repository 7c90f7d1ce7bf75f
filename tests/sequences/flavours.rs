//! The suite in each flavour of Rapier whose feature is on, with what depends on its version. The fuzzer compiles this file as well.

#[path = "../common/flavours.rs"]
#[macro_use]
mod list;

use crate::ops::Sequence;

#[allow(unused_macros)]
macro_rules! flavour {
    ($name:ident, $rapier:ident, $unisize:ident, $dim:tt, $version:tt) => {
        #[path = "."]
        mod $name {
            use unisize::$unisize::{Settings, UnisizeBroadPhase};
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

/// Plays a sequence with lists made by hand, in one of the flavours whose features are on.
pub(crate) fn play(sequence: &Sequence, flavour: usize) {
    let mut plays: Vec<fn(&Sequence)> = Vec::new();
    macro_rules! add {
        ($name:ident, $($rest:tt),*) => {
            plays.extend([$name::suite::play as fn(&Sequence)]);
        };
    }
    for_each_027!(add);
    for_each_036!(add);
    plays[flavour % plays.len()](sequence);
}
