//! The suite for rapier2d.

use rapier2d as rapier;
use unisize::rapier2d::UnisizeBroadPhase;
#[cfg(feature = "enhanced-determinism")]
use unisize::rapier2d::{PairFilter, Settings};
use unisize_scenes::dim2::PairEvent;
#[cfg(feature = "enhanced-determinism")]
use unisize_scenes::dim2::{Observed, Scene};

/// By replay.
const REPLAYS: [u64; 6] = [
    0x470795fb48856718,
    0xd6164d58bc226b73,
    0xef1941d963668511,
    0x618d16bb68415165,
    0x0bb44bf830240f75,
    0x0022006aeccf9b30,
];

/// By scene.
#[cfg(feature = "enhanced-determinism")]
const SCENES: [u64; 19] = [
    0xbcecf202e65bda65,
    0x6342bc289035b930,
    0x9fbb324a2187e108,
    0x37ea7f8f7698ae13,
    0x0dc191629abe4923,
    0x853ca51ac6563bdf,
    0xc80cfb6e47d0fdd8,
    0x9d2573815a8ec274,
    0x447936cfe52fd7d0,
    0x44dcf98d7a6d1f7a,
    0x17c14344a2c37a67,
    0x108130fab755c3a8,
    0x0dcee881880f0316,
    0x31e9dad2c7d18b06,
    0xb154d9a6bff99d0c,
    0xde89350bfac0fcd5,
    0xcd369aac949195e9,
    0xed986870577021a7,
    0x82fc26294c8e1b95,
];

#[path = "suite.rs"]
mod suite;
