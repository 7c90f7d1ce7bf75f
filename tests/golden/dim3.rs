//! The suite for rapier3d.

use rapier3d as rapier;
#[cfg(feature = "enhanced-determinism")]
use unisize::rapier3d_027::PairFilter;
use unisize::rapier3d_027::{Kernel, Settings, UnisizeBroadPhase};
use unisize_scenes::dim3::PairEvent;
#[cfg(feature = "enhanced-determinism")]
use unisize_scenes::dim3::{Observed, Scene};

/// By replay.
const REPLAYS: [u64; 6] = [
    0x2609633913664ee1,
    0xcebc30a132a0a6c8,
    0xce2917414493e18c,
    0xec14e9401dba5672,
    0x503eb0b3351d59c2,
    0x49c23ec460fb0d4e,
];

/// By scene.
#[cfg(feature = "enhanced-determinism")]
const SCENES: [u64; 25] = [
    0x9da3153973578b73,
    0x17ac56d15b14ce4d,
    0x186a26ea48525dc1,
    0x2f9aa5a89d9e6531,
    0xc0cb44a6701c9793,
    0xcc7aa2aeeb4f9d49,
    0x788711029d842dc4,
    0xe842f84a21e9b31a,
    0x34062c0b385251a1,
    0xb9cc1f2d170a8562,
    0x54e87d7ba0ee2712,
    0x865b06e2659f787c,
    0x7a2748084eebe321,
    0xec344b7e8e645f57,
    0xff15a0cac54be981,
    0x83a89edb490b6f53,
    0x91f6f989aa632ba5,
    0x501efa143814582d,
    0x8b4fe531480c82d3,
    0x364bad0e33e257df,
    0x5b7d01def018db43,
    0xcaffee40315e5285,
    0x77f024525c88cd4f,
    0xad4d793ea1af348e,
    0x200facf01f8a0cb0,
];

#[path = "suite.rs"]
mod suite;
