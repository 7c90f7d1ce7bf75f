//! The suite for rapier3d-f64.

use rapier3d_f64 as rapier;
#[cfg(feature = "enhanced-determinism")]
use unisize::rapier3d_f64::PairFilter;
use unisize::rapier3d_f64::{Kernel, Settings, UnisizeBroadPhase};
use unisize_scenes::dim3_f64::PairEvent;
#[cfg(feature = "enhanced-determinism")]
use unisize_scenes::dim3_f64::{Observed, Scene};

/// By replay.
const REPLAYS: [u64; 6] = [
    0xb0a39f6fd6b60352,
    0xf2a5db4f644a3c7c,
    0xf83580695d42826c,
    0x56ac2ab10a9dbd0a,
    0x9cf6d753f02cc2ea,
    0xa2b5cc96ebbfd9dd,
];

/// By scene.
#[cfg(feature = "enhanced-determinism")]
const SCENES: [u64; 25] = [
    0xa87f97e3e1852ed2,
    0x065fd72b53b8bc7d,
    0xdd7f319d79867098,
    0xce48034bc2ffb977,
    0x7f9f8bdd893e4a72,
    0x29fec5cb18dfaddb,
    0x024a7fc21d2521fa,
    0xbf6ffe66ff28407a,
    0x4fe8e44b01702cd1,
    0x4ec9fceada718202,
    0x9e3631081fa2cd02,
    0xf707c428a8cb14ac,
    0x2f584b93a6336e33,
    0x6cd68c56dde78479,
    0xbde9b8c7b561419b,
    0x7b44b92953070937,
    0xa6c52a965f18540f,
    0xbcefd8986fef6570,
    0x89baa39164fbe5b3,
    0xf775aff6c1a0eda6,
    0xaa101353474667cc,
    0x0c9f0556a7482545,
    0x4bea7ba5a03037af,
    0x7605ddf42f95d2be,
    0xb00b50c93d62c5c0,
];

#[path = "suite.rs"]
mod suite;
