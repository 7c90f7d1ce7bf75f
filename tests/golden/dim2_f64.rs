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
    0x8541d3077ccc43e6,
    0x8740e64866bee38d,
    0xfd883198de31b7b1,
    0x526202b18c242af1,
    0x40502de750fdd661,
    0x54303ea0acd9d00b,
];

/// By scene.
#[cfg(feature = "enhanced-determinism")]
const SCENES: [u64; 19] = [
    0xd75d4fc539032bf7,
    0x6342bc289035b930,
    0x22b177a85a3be5b9,
    0x861dbe9c7638ec65,
    0x80f0fcf37f5bde1a,
    0x853ca51ac6563bdf,
    0xc80cfb6e47d0fdd8,
    0x9d2573815a8ec274,
    0xb96c9896c819c152,
    0x5b2db36e4afbe688,
    0xd4f90b91bdc71bf5,
    0x65382c7bd31626a1,
    0x1c1ca308a61f3752,
    0x895327dace4cfe60,
    0x94c443793465a576,
    0xbf9380aee2bfd177,
    0xcd369aac949195e9,
    0x996275e2873f862f,
    0xafe1de8d1dbfed3e,
];

#[path = "suite.rs"]
mod suite;
