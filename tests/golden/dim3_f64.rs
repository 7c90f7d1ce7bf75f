//! The suite for rapier3d-f64.

use rapier3d_f64 as rapier;
#[cfg(feature = "enhanced-determinism")]
use unisize::rapier3d_f64_027::PairFilter;
use unisize::rapier3d_f64_027::{Kernel, Settings, UnisizeBroadPhase};
use unisize_scenes::dim3_f64::PairEvent;
#[cfg(feature = "enhanced-determinism")]
use unisize_scenes::dim3_f64::{Observed, Scene};

/// By replay.
const REPLAYS: [u64; 6] = [
    0x35cac31bc5d0a66e,
    0xcebc30a132a0a6c8,
    0xce2917414493e18c,
    0xec14e9401dba5672,
    0x503eb0b3351d59c2,
    0xb9e6cd6d058789e1,
];

/// By scene.
#[cfg(feature = "enhanced-determinism")]
const SCENES: [u64; 25] = [
    0xf9f39943d91bfd63,
    0x17ac56d15b14ce4d,
    0x46e06cfe15d073ec,
    0xe417971bc3076198,
    0x8255951fac1c5392,
    0x80170a3b8d801b89,
    0x60fbbb07999f6c3a,
    0xe842f84a21e9b31a,
    0x34062c0b385251a1,
    0xb9cc1f2d170a8562,
    0x54e87d7ba0ee2712,
    0x865b06e2659f787c,
    0xd3e4a660f84a0c73,
    0x2bc4aff1b0195eb2,
    0xff15a0cac54be981,
    0x74e01bbf85899e75,
    0x91f6f989aa632ba5,
    0x436d1ad337ad6273,
    0x8b4fe531480c82d3,
    0xd05036699ef2d436,
    0xe3b3cd4a14bbc271,
    0xcaffee40315e5285,
    0x77f024525c88cd4f,
    0xad4d793ea1af348e,
    0x200facf01f8a0cb0,
];

#[path = "suite.rs"]
mod suite;
