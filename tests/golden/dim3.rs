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
const SCENES: [u64; 19] = [
    0x84c3c22759bcd322,
    0x9975a8338cbe766d,
    0x38dfb4250ff72231,
    0x4853dd71c8bfbecb,
    0x5f5ccdb6190d1d95,
    0x771726bc323f1704,
    0x6658c2176fcbe39a,
    0xc0e1fbecb453faa1,
    0x8661b0784f559c22,
    0x4f5278d2ec7ede52,
    0x941cd146e0b6341c,
    0x597b12bac1441de1,
    0x38c9c8fbea0f52c3,
    0xfb74257d15c56af9,
    0xbc74e5d4e03e2fc0,
    0x0a5466930ed18468,
    0xc86502f53146d093,
    0xeb38cb79d735018f,
    0x8341df0ff1a5c4a7,
];

#[path = "suite.rs"]
mod suite;
