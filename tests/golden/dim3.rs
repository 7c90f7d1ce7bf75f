//! The suite for rapier3d.

use rapier3d as rapier;
use unisize::rapier3d::UnisizeBroadPhase;
#[cfg(feature = "enhanced-determinism")]
use unisize::rapier3d::{PairFilter, Settings};
use unisize_scenes::dim3::PairEvent;
#[cfg(feature = "enhanced-determinism")]
use unisize_scenes::dim3::{Observed, Scene};

/// By replay.
const REPLAYS: [u64; 6] = [
    0x361fc98d18538aed,
    0xfc4b0e8e52544f80,
    0xdafe624b3c445db4,
    0x651a0a4548fe8c6e,
    0x856f8f2e705ac0de,
    0x48b94592df4635e6,
];

/// By scene.
#[cfg(feature = "enhanced-determinism")]
const SCENES: [u64; 21] = [
    0x883bf450c48812d5,
    0x9975a8338cbe766d,
    0xc0136e9713d0d67b,
    0x1a728c624412e2a7,
    0x3af68eb035a89b23,
    0x1198c81bb7b18ff0,
    0x68facd0436292344,
    0x2d563d5ff124719a,
    0xc0e1fbecb453faa1,
    0xc534871509a307b2,
    0x6b5de1acdf534552,
    0x55aaa44b1e0e691c,
    0x41c16295fd192a81,
    0xc84614109760b17d,
    0x5d23df2765a865f3,
    0x41e927d9c5a9c907,
    0xcf25b3acdfab9fbf,
    0xd1f2068e216a7bd8,
    0xc86502f53146d093,
    0x38fc9794aeaa30bf,
    0xf00cd4629969a966,
];

#[path = "suite.rs"]
mod suite;
