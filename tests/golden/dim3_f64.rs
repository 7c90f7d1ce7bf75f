//! The suite for rapier3d-f64.

use rapier3d_f64 as rapier;
use unisize::rapier3d_f64::UnisizeBroadPhase;
#[cfg(feature = "enhanced-determinism")]
use unisize::rapier3d_f64::{PairFilter, Settings};
use unisize_scenes::dim3_f64::PairEvent;
#[cfg(feature = "enhanced-determinism")]
use unisize_scenes::dim3_f64::{Observed, Scene};

/// By replay.
const REPLAYS: [u64; 6] = [
    0x52e617281998aa32,
    0xfc4b0e8e52544f80,
    0xdafe624b3c445db4,
    0x24facf216e8359ba,
    0x5106e6118ad96346,
    0x31d01c4b949b23e9,
];

/// By scene.
#[cfg(feature = "enhanced-determinism")]
const SCENES: [u64; 21] = [
    0x883bf450c48812d5,
    0x9975a8338cbe766d,
    0xc8310c0d57a91f81,
    0x5ef9dda3937363f1,
    0xf6d706a2c8974692,
    0x61e7cd25a31e89ea,
    0x1497e939fcccbb8a,
    0x2d563d5ff124719a,
    0xc0e1fbecb453faa1,
    0xc534871509a307b2,
    0x6b5de1acdf534552,
    0x55aaa44b1e0e691c,
    0x58c22a2cf3b75fa3,
    0x32a2db20fbd1e6c3,
    0x5d23df2765a865f3,
    0xfc66d96bb6b02f95,
    0xcdf8f8d1d3171757,
    0xc2aca014c409cb4e,
    0xc86502f53146d093,
    0x6caebe7a3da83646,
    0xf27bdac4db5dcdbb,
];

#[path = "suite.rs"]
mod suite;
