//! The suite for rapier2d-f64.

use rapier2d_f64 as rapier;
#[cfg(feature = "enhanced-determinism")]
use unisize::rapier2d_f64_027::PairFilter;
use unisize::rapier2d_f64_027::{Kernel, Settings, UnisizeBroadPhase};
use unisize_scenes::dim2_f64::PairEvent;
#[cfg(feature = "enhanced-determinism")]
use unisize_scenes::dim2_f64::{Observed, Scene};

/// By replay.
const REPLAYS: [u64; 6] = [
    0xb3587c0f343e741e,
    0x0fe366d26ccd3e59,
    0x3faab311f2b6e6c9,
    0xdc974a64fa6fa335,
    0x0d337e734b16502d,
    0x663cbc58f1aafb8f,
];

/// By scene.
#[cfg(feature = "enhanced-determinism")]
const SCENES: [u64; 25] = [
    0x4340172bd74a6b45,
    0x3a111dc2e02ff510,
    0x7fccd3c0a3db2199,
    0xcb6201005fa4dc9a,
    0x185660bf703f5ceb,
    0x136d95946979414c,
    0xe4d230f85caac61f,
    0xc0cd6ffd8c1653b8,
    0x0215f7f55d9dcc84,
    0x238972a249b85b32,
    0x25028895ce426898,
    0x66041223a737a604,
    0x34074e79e8046c06,
    0xa1ad7d0fa76f119d,
    0x3238eb9bdef441ae,
    0xc2fb3913406c6747,
    0x7c59606aa8d8704b,
    0x98a742630c254c5e,
    0xf2c9588347af13d9,
    0x705e6e47cd2eb54f,
    0x229138bbe2f2e790,
    0xdf4118528de63d55,
    0x77f024525c88cd4f,
    0x8ab8e09d859741fd,
    0x12ad02e7c5999e3f,
];

#[path = "suite.rs"]
mod suite;
