//! The suite: one source for every flavour, which the module that includes it names as `rapier`, and what depends on
//! Rapier's version as `version`.

use super::{Settings, UnisizeBroadPhase, dim, rapier, version};

pub(super) mod checked;
mod direct;
#[cfg(test)]
mod distances;
mod model;
#[cfg(test)]
mod shapes;
#[cfg(test)]
mod sizes;
mod volume;
mod world;

#[cfg(test)]
use crate::cases::cases;
#[cfg(test)]
use crate::random_values::check;
#[cfg(test)]
use crate::strategies::{SEQUENCES, sequences};
#[cfg(test)]
pub(super) use shapes::Solid;
pub(super) use world::{HandedOver, World};

/// Plays a sequence with lists made by hand.
pub(crate) fn play(sequence: &crate::ops::Sequence) {
    direct::play(sequence);
}

/// A turn.
fn rotation(angles: crate::ops::Triple) -> version::Pose {
    let collider = rapier::prelude::ColliderBuilder::ball(1.0).rotation(dim::turn(angles));
    *collider.build().position()
}

#[cfg(test)]
#[test]
fn lists_made_by_hand() {
    check(SEQUENCES, &sequences(), direct::play);
}
