//! The suite for rapier2d-f64.

use rapier2d_f64 as rapier;
#[cfg(feature = "enhanced-determinism")]
use unisize::rapier2d_f64::PairFilter;
use unisize::rapier2d_f64::{Kernel, Settings, UnisizeBroadPhase};
use unisize_scenes::dim2_f64::PairEvent;
#[cfg(feature = "enhanced-determinism")]
use unisize_scenes::dim2_f64::{Observed, Scene};

/// By replay.
const REPLAYS: [u64; 6] = [
    0x05af2dea57e8e0de,
    0x61a82886b08d0025,
    0xc13f688a463dcd79,
    0xe7c439dab5ab987d,
    0x5d366d613d097c09,
    0x8ffa9eb53d853e07,
];

/// By scene.
#[cfg(feature = "enhanced-determinism")]
const SCENES: [u64; 25] = [
    0xb2e6e1d82a9cbe2a,
    0xe55d8756d6768d60,
    0xb888ab66749ecd79,
    0xdac95441fc3d9d32,
    0x0c86c7db928a85f8,
    0x464e5a0886642dd2,
    0xc449d40a56d1c3df,
    0x3bb584b2eb5cae58,
    0x1f44393b25b862e4,
    0x931bd6fdc5cb65f1,
    0xa2cc948eade4bf58,
    0x6fbbdc0bdc9e6094,
    0x9bf45bba8a39bc85,
    0xef0c58b0fd9e0748,
    0x187934302b756427,
    0x250f125243f285cd,
    0xf90d653f057ddfa1,
    0xb761b54ea2938185,
    0xf3234a725782f789,
    0xdd294c00b3c66d7f,
    0x1144c54fd3f0abb0,
    0xe45979a9a61f20c5,
    0x4bea7ba5a03037af,
    0xd11d1ee9fa12e0ad,
    0x09adf3028068648f,
];

#[path = "suite.rs"]
mod suite;
