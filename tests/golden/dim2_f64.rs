//! The suite for rapier2d-f64.

use rapier2d_f64 as rapier;
use unisize::rapier2d_f64::UnisizeBroadPhase;
#[cfg(feature = "enhanced-determinism")]
use unisize::rapier2d_f64::{PairFilter, Settings};
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
    0x80c71ee7c011e99b,
    0x6342bc289035b930,
    0xa5b5324c890e8a69,
    0x790059a6bf5e4739,
    0x84c44eaa9e74a421,
    0x18be41068e0c02b1,
    0xb011fb46aed5555f,
    0x2aba51e6cc5617c8,
    0x9d2573815a8ec274,
    0x7d2e039e585dc9f0,
    0x9ed39394ac4fdc8c,
    0x3bcd9610de3abb60,
    0x3af53f14c48e5399,
    0xacf81003209f937d,
    0xe0294adf925807d2,
    0xd9064e8a2770e840,
    0xf3063bf9d13233c2,
    0xbf9380aee2bfd177,
    0xcd369aac949195e9,
    0x3c29d133d6ac86df,
    0x12a366f4cf3fd229,
    0x1751054cf85183c5,
    0xd88f61307bdd5d0f,
    0x1eb108af16d75c8d,
    0xb852aecff81072ff,
];

#[path = "suite.rs"]
mod suite;
