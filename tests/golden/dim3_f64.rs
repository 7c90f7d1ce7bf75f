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
    0xd3d61c844ee380cf,
    0x9975a8338cbe766d,
    0xf85eea6055b75d3d,
    0xa68912093216425f,
    0xf6d706a2c8974692,
    0x51224bbf2bc7e3b3,
    0x1497e939fcccbb8a,
    0x535d3be784263c7a,
    0xc0e1fbecb453faa1,
    0xc534871509a307b2,
    0xf373315de0002bd2,
    0x55aaa44b1e0e691c,
    0x3c3fb3037e7195c3,
    0xd1d9f9ebd3a1946d,
    0x0d47b65f344f47a5,
    0x9d88fa08ac05488c,
    0xcdf8f8d1d3171757,
    0xc2aca014c409cb4e,
    0xc86502f53146d093,
    0xdbd0d9d6bcaf8e36,
    0x526be7fc5ec8fdd9,
    0x230a30256d679555,
    0xee606903da2e374f,
    0xb1553818a74128be,
    0xaf854e363a949c80,
];

#[path = "suite.rs"]
mod suite;
