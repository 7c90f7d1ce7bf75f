//! The suite for rapier2d.

use rapier2d as rapier;
#[cfg(feature = "enhanced-determinism")]
use unisize::rapier2d_027::PairFilter;
use unisize::rapier2d_027::{Kernel, Settings, UnisizeBroadPhase};
use unisize_scenes::dim2::PairEvent;
#[cfg(feature = "enhanced-determinism")]
use unisize_scenes::dim2::{Observed, Scene};

/// By replay.
const REPLAYS: [u64; 6] = [
    0xa395992467b668c4,
    0x35989b686b865feb,
    0x3faab311f2b6e6c9,
    0x02a3a38930b76561,
    0x0d337e734b16502d,
    0xf71b3a4a4958e678,
];

/// By scene.
#[cfg(feature = "enhanced-determinism")]
const SCENES: [u64; 25] = [
    0xd72017fb53757c37,
    0x3a111dc2e02ff510,
    0x6609e7ceb62f4f28,
    0x443c8d1e046acb38,
    0xe7ef490261e54cbf,
    0x0deee0255cc560f3,
    0xe4d230f85caac61f,
    0xc0cd6ffd8c1653b8,
    0x0215f7f55d9dcc84,
    0x36ca571b9282ec51,
    0x7bef29653dbcc4c2,
    0xd22ef7dc19c40d44,
    0xd151c38316b51d3b,
    0x267eb147995f67ea,
    0xd18669d5275eec4a,
    0x84ab3c0049dfe7f5,
    0x7c59606aa8d8704b,
    0x6b6ace33b8dfb46c,
    0xf2c9588347af13d9,
    0x127942210613d3c7,
    0x9325b6c0c3e6d027,
    0xdf4118528de63d55,
    0x77f024525c88cd4f,
    0x8ab8e09d859741fd,
    0x12ad02e7c5999e3f,
];

#[path = "suite.rs"]
mod suite;
